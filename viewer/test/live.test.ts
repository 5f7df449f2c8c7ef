import { describe, expect, test } from "vitest";
import { makeMotion } from "../src/frames";
import { LiveFrames } from "../src/live_frames";
import { readBytes, readText, type LiveCommand, type LiveFrame, type LiveHistory } from "../src/live_message";
import { withPlanes } from "../src/live_extent";
import { LiveSource } from "../src/live_source";
import { inBody, nearestOnRay, onPlane } from "../src/live_tools";
import { bodyCurves } from "../src/plots";
import { loadRuns } from "../src/run";
import { header, pageBlocks, Writer } from "./bytes";

/** A frame of one body and one contact, with two values of series. */
function frameBytes(time: number, series: number[], body: number[], contact?: number[]): ArrayBuffer {
  const contacts = contact ? 1 : 0;
  const view = new DataView(new ArrayBuffer(28 + 8 * series.length + 52 + 52 * contacts));
  [1, 7, 1, contacts, series.length].forEach((value, i) => view.setUint32(4 * i, value, true));
  view.setFloat64(20, time, true);
  series.forEach((value, i) => view.setFloat64(28 + 8 * i, value, true));
  const at = 28 + 8 * series.length;
  body.forEach((value, i) => view.setFloat32(at + 4 * i, value, true));
  contact?.forEach((value, i) => (i < 3 ? view.setUint32(at + 52 + 4 * i, value, true) : view.setFloat32(at + 52 + 4 * i, value, true)));
  return view.buffer;
}
const origin: [number, number, number] = [10, 0, 0];
const body = [1, 2, 3, 0, 0, 0, 1, 4, 5, 6, 7, 8, 9];

/** Two rows of two series; two events, the later one first. */
function historyBytes(): ArrayBuffer {
  const writer = new Writer();
  [3, 7, 2, 2, 2].forEach((value) => writer.u32(value));
  [9, 0, 3, 0.5, 4].forEach((value) => writer.f64(value));
  for (const time of [0.25, 0.125]) {
    writer.f64(time);
    [0, 0, 1].forEach((value) => writer.u32(value));
    const floats = new DataView(new Float32Array([1, 2, 3, 0, 0, 5]).buffer);
    for (let at = 0; at < 24; at += 4) writer.u32(floats.getUint32(at, true));
  }
  return writer.array.buffer as ArrayBuffer;
}

describe("messages of a live simulation", () => {
  test("a frame is read back number by number", () => {
    const frame = readBytes(frameBytes(0.5, [0.5, 8], body, [0, 1, 2, -0.25, 1, 2, 3, 0, 0, 1, 0, 0, 5]), origin) as LiveFrame;
    expect(frame.generation).toBe(7);
    expect(frame.time).toBe(0.5);
    expect([...frame.series]).toEqual([0.5, 8]);
    expect([...frame.bodies]).toEqual(body);
    expect(frame.contacts).toEqual([{ bodyA: 0, bodyB: 1, mode: "slide", gap: -0.25, point: [1, 2, 3], normal: [0, 0, 1], force: [0, 0, 5] }]);
  });

  test("what is cut or of an unknown kind is told", () => {
    const whole = frameBytes(0, [1], body);
    for (const length of [0, 4, 20, 30, whole.byteLength - 1]) expect(() => readBytes(whole.slice(0, length), origin)).toThrow();
    expect(() => readBytes(Uint32Array.of(9, 9, 9).buffer, origin)).toThrow("unknown kind");
    expect(() => readBytes(Uint32Array.of(2, 1000).buffer, origin)).toThrow("cut");
    expect(() => readText('{"type": "other"}')).toThrow("unknown kind");
  });

  test("a history is read back, its events in the order of their times and places in the world", () => {
    const history = readBytes(historyBytes(), origin) as LiveHistory;
    expect(history.generation).toBe(7);
    expect(history.columns.map((column) => [...column])).toEqual([[0, 0.5], [3, 4]]);
    expect(history.events).toEqual([0.125, 0.25].map((time) => ({ kind: "impact", time, bodyA: 0, bodyB: 1, point: [11, 2, 3], impulse: [0, 0, 5] })));
    expect(() => readBytes(historyBytes().slice(0, -1), origin)).toThrow("length");
    expect(() => readBytes(historyBytes().slice(0, 20), origin)).toThrow("cut");
  });

  test("a file comes with its name", () => {
    const bytes = Uint8Array.of(2, 0, 0, 0, 3, 0, 0, 0, 97, 46, 98, 1, 2);
    expect(readBytes(bytes.buffer, origin)).toEqual({ name: "a.b", bytes: Uint8Array.of(1, 2) });
  });

  test("commands are the JSON that the server reads", () => {
    const pull: LiveCommand = { do: "pull", body: 1, point: [0, 0, 0.5], target: [1, 2, 3] };
    expect(JSON.stringify(pull)).toBe('{"do":"pull","body":1,"point":[0,0,0.5],"target":[1,2,3]}');
  });
});

describe("a live source", () => {
  const sourceOf = async () => new LiveSource((await loadRuns(pageBlocks(), 6, () => {})).runs[0]);
  const frame = (time: number, series: number[]) => readBytes(frameBytes(time, series, body), origin) as LiveFrame;

  test("begins with the moment that the page holds, and goes on with the newest frame", async () => {
    const source = await sourceOf();
    const motion = makeMotion(2);
    source.sample(0, motion);
    expect([...motion.position]).toEqual([-9, 2, 3, 1, 0, 1]);
    let told = 0;
    source.onFrame = () => ++told;
    source.take(frame(0.25, [0.25, 8]));
    source.sample(99, motion);
    expect(told).toBe(1);
    expect(source.time).toBe(0.25);
    expect([...motion.position]).toEqual([-9, 2, 3, 1, 2, 3]);
    expect([...motion.velocity.slice(3)]).toEqual([4, 5, 6]);
    expect([...motion.spin.slice(3)]).toEqual([7, 8, 9]);
  });

  test("has the series and events of its history", async () => {
    const source = await sourceOf();
    let told = 0;
    source.onHistory = () => ++told;
    source.remember(readBytes(historyBytes(), origin) as LiveHistory);
    expect(told).toBe(1);
    expect([...source.times]).toEqual([0, 0.5]);
    expect([...(source.series.get("kinetic") ?? [])]).toEqual([3, 4]);
    expect(source.events.map(({ time }) => time)).toEqual([0.125, 0.25]);
    expect(source.eventCount).toBe(9);
  });

  test("keeps the motion that it has seen, and forgets it at a reset", async () => {
    const source = await sourceOf();
    for (const time of [0.25, 0.5, 0.5]) source.take(frame(time, []));
    expect([...source.frameTimes]).toEqual([0, 0.25, 0.5]);
    expect(bodyCurves(source, 1, "position").map((curve) => curve[2])).toEqual([11, 2, 3]);
    // ½ m v² with 2 kg and (4, 5, 6) m/s; ½ ω · I ω with moments of 1 and (7, 8, 9) rad/s.
    expect(bodyCurves(source, 1, "kinetic energy").map((curve) => curve[2])).toEqual([77, 97]);
    source.take(frame(0.125, []));
    expect([...source.frameTimes]).toEqual([0.125]);
  });
});

describe("the motion that a live page keeps", () => {
  test("is bounded, evenly spaced and ends with the newest", () => {
    const frames = new LiveFrames([1]);
    const count = 10000;
    for (let k = 0; k < count; ++k) frames.add(k, Float32Array.from([k, ...body.slice(1)]));
    const { times } = frames;
    expect(times.length).toBeLessThanOrEqual(1024);
    expect(times.length).toBeGreaterThan(400);
    expect(times[times.length - 1]).toBe(count - 1);
    const mean = count / times.length;
    for (let i = 1; i < times.length - 1; ++i) {
      expect(times[i] - times[i - 1]).toBeGreaterThan(0.4 * mean);
      expect(times[i] - times[i - 1]).toBeLessThan(2.5 * mean);
    }
    for (let i = 0; i < times.length; ++i) expect(frames.position[3 * i]).toBe(times[i]);
  });

  test("of many bodies has few rows", () => {
    const frames = new LiveFrames(Array.from({ length: 100_000 }, (_, i) => i));
    const bodies = new Float32Array(1_300_000);
    for (let k = 0; k < 40; ++k) frames.add(k, bodies);
    expect(frames.times.length).toBeLessThanOrEqual(16);
    expect(frames.times[frames.times.length - 1]).toBe(39);
  });
});

describe("pulling", () => {
  const ray = { from: [0, 0, 10] as [number, number, number], direction: [0, 0, -1] as [number, number, number], forward: [0, 0, -1] as [number, number, number] };

  test("a body is held where the line of sight is nearest to its centre", () => {
    expect(nearestOnRay(ray, [3, 0, 2])).toEqual([0, 0, 2]);
  });

  test("the target moves in a plane before the eye; behind it there is none", () => {
    expect(onPlane(ray, [5, 5, 4], [0, 0, -1])).toEqual([0, 0, 4]);
    expect(onPlane(ray, [0, 0, 12], [0, 0, -1])).toBeUndefined();
    expect(onPlane(ray, [0, 0, 4], [1, 0, 0])).toBeUndefined();
  });

  test("a point is told in the frame of the body", () => {
    const motion = makeMotion(1);
    motion.position.set([1, 0, 0]);
    // A quarter turn about z takes the body's x to the world's y.
    motion.orientation.set([0, 0, Math.SQRT1_2, Math.SQRT1_2]);
    const point = inBody(motion, 0, [1, 2, 0]);
    [2, 0, 0].forEach((value, c) => expect(point[c]).toBeCloseTo(value, 6));
  });
});

describe("what a live page looks at", () => {
  test("reaches down to a plane below the bodies, not to one far away or above", () => {
    const plane = (offset: number) => ({ type: "plane" as const, normal: [0, 0, 1] as [number, number, number], offset, p: [0, 0, 0] as [number, number, number], q: [1, 0, 0, 0] as [number, number, number, number], material: 0, color: "" });
    const level = { ...header, bodies: header.bodies.map((own) => ({ ...own, start: { p: [0, 0, 0] as [number, number, number], q: [1, 0, 0, 0] as [number, number, number, number] } })) };
    const extent = { center: [0, 0, 5] as [number, number, number], half: [1, 1, 1] as [number, number, number], radius: Math.sqrt(3) };
    expect(withPlanes({ ...level, looks: [[plane(1)], []] }, extent)).toEqual({ center: [0, 0, 3.5], half: [1, 1, 2.5], radius: Math.hypot(1, 1, 2.5) });
    for (const offset of [-1000, 6]) expect(withPlanes({ ...level, looks: [[plane(offset)], []] }, extent)).toEqual(extent);
  });
});
