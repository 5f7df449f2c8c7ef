import { describe, expect, test } from "vitest";
import { Reader } from "../src/reader";
import { loadRuns } from "../src/run";
import { unpackQuaternion } from "../src/frames";
import { blockOf, header, pageBlocks, Writer } from "./bytes";

const quiet = () => {};

describe("reader", () => {
  test("varints are exact to two to the 52nd", () => {
    const values = [0, -1, 1, 63, 64, -64, -65, 8191, 8192, 2 ** 31, -(2 ** 31), 2 ** 51, -(2 ** 51)];
    const writer = new Writer();
    values.forEach((value) => writer.varint(value));
    const reader = new Reader(writer.array);
    expect(values.map(() => reader.varint())).toEqual(values);
  });

  test("what ends too early throws", () => {
    expect(() => new Reader(Uint8Array.of(0x80)).varint()).toThrow(/ends inside a number/);
    expect(() => new Reader(Uint8Array.of(1, 2)).f64()).toThrow(/ends before/);
    expect(() => new Reader(Uint8Array.of(2)).column(3, 1, new Float32Array(3), 0, 1)).toThrow();
  });

  test("the left-out component of a quaternion is positive and makes it a unit one", () => {
    const q = new Float32Array(4);
    unpackQuaternion(2, [16384, -8000, 100], 0, q, 0);
    expect(Math.hypot(...q)).toBeCloseTo(1, 6);
    // Components are w x y z, kept as x y z w; y was left out.
    expect(q[1]).toBeGreaterThan(0);
    expect(q[3]).toBeCloseTo((16384 * Math.SQRT1_2) / 32767, 6);
    expect(q[0]).toBeLessThan(0);
  });
});

describe("numbers to the last bit", () => {
  test("come back as they were written, of whatever kind", () => {
    const values = [0, -0, 1, 1 + 2 ** -52, 0.1, -0.1, 1e300, -1e-300, 5e-324, Infinity, -Infinity, 3, 3, 3];
    const reader = new Reader(new Writer().f64(7).exactColumn(values).u32(9).array);
    expect(reader.f64()).toBe(7);
    const read = reader.exactColumn(values.length);
    values.forEach((value, k) => expect(Object.is(read[k], value)).toBe(true));
    expect(reader.u32()).toBe(9);
    expect(() => new Reader(new Writer().exactColumn([1, 2]).array).exactColumn(3)).toThrow("ends before");
  });
});

describe("runs", () => {
  test("a page gives motion, series, events and contacts", async () => {
    const { runs, problems } = await loadRuns(pageBlocks(), 6, quiet);
    expect(problems).toEqual([]);
    const [run] = runs;
    expect([...run.times]).toEqual([0, 0.5, 1]);
    expect([...(run.series.get("kinetic") ?? [])]).toEqual([7, 8, 9]);
    expect(run.frames.moving).toEqual([1]);
    expect([...run.frames.position]).toEqual([1, 0, 1, 2, 0, 0, 3, 0, 1]);
    expect([...run.frames.velocity.slice(0, 3)]).toEqual([2, 0, -2]);
    expect([...run.frames.spin]).toEqual([0.25, 0, 0, 0.5, 0, 0, 0.75, 0, 0]);
    expect(run.events).toEqual([
      { kind: "impact", time: 0.5, bodyA: 0, bodyB: 1, point: [10.125, 0.25, 0.375], impulse: [0, 0, -3] },
    ]);
    expect(run.contacts.at(0)).toEqual([
      { bodyA: 0, bodyB: 1, mode: "stick", gap: -0.5, point: [1, 0, 0.5], normal: [0, 0, 1], force: [2, 0, 10] },
    ]);
    // Differences add up: 5, 5 + 1, 5 + 1 + 2.
    expect(run.contacts.at(2)[0].force).toEqual([2, 0, 16]);
    // The ball is at x = 1, 2, 3 then.
    expect([0, 1, 2].map((frame) => run.contacts.at(frame)[0].point[0])).toEqual([1, 2.125, 3.25]);
  });

  test("without its header there is nothing to show", async () => {
    const blocks = pageBlocks();
    blocks[0].text = blocks[0].text.slice(0, 40);
    await expect(loadRuns(blocks, 6, quiet)).rejects.toThrow(/the header block is cut/);
    await expect(loadRuns([], 6, quiet)).rejects.toThrow(/holds no data blocks/);
    await expect(loadRuns(pageBlocks().slice(1), 6, quiet)).rejects.toThrow(/5 of 6 data blocks.*the header block is missing/);
  });

  test("damaged frames are told, and what is before them is shown", async () => {
    const blocks = pageBlocks();
    blocks.push({ ...blocks[4], crc: "00000000" });
    const text = JSON.stringify({ ...header, frames: 6 });
    blocks[0] = blockOf("header", new TextEncoder().encode(text));
    const series = new Writer().exactColumn([0, 1, 2, 3, 4, 5]).exactColumn([6, 7, 8, 9, 10, 11]);
    blocks[2] = blockOf("series", series.array);
    const { runs, problems } = await loadRuns(blocks, 7, quiet);
    expect(runs[0].frames.count).toBe(3);
    expect(runs[0].times.length).toBe(3);
    expect(problems).toEqual([expect.stringMatching(/the frames block is damaged/), "the first 3 of 6 frames are shown"]);
  });

  test("without events or with a broken ghost the run is shown all the same", async () => {
    const blocks = pageBlocks();
    blocks[3].text = "AAAA";
    const ghost = pageBlocks().map((block) => ({ ...block, run: 1 }));
    ghost[0].crc = "00000000";
    const { runs, problems } = await loadRuns([...blocks, ...ghost], 12, quiet);
    expect(runs.length).toBe(1);
    expect(problems).toEqual([expect.stringMatching(/events.*no events are shown/), expect.stringMatching(/header block is damaged/)]);
  });

  test("a later format is refused by name", async () => {
    const blocks = pageBlocks();
    blocks[0] = blockOf("header", new TextEncoder().encode(JSON.stringify({ ...header, format: 3 })));
    await expect(loadRuns(blocks, 6, quiet)).rejects.toThrow("format 3; this viewer knows format 2");
  });
});
