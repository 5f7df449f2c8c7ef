import { describe, expect, test } from "vitest";
import { auditRows, auditText, isSound } from "../src/audit_rows";
import { tableOf, unitText, valueUnit } from "../src/chart";
import { comparedRows } from "../src/compare_audits";
import { widest } from "../src/compare_plots";
import { loadRuns } from "../src/run";
import { nextChoice } from "../src/run_choice";
import { runColor, runNames, shortNames } from "../src/run_names";
import { RecordedSource } from "../src/source";
import { blockOf, header, pageBlocks } from "./bytes";

/** Blocks of one run of a page, with its name. */
function blocksOf(run: number, label: string) {
  const blocks = pageBlocks().map((block) => ({ ...block, run }));
  return [blockOf("header", new TextEncoder().encode(JSON.stringify({ ...header, label })), run), ...blocks.slice(1)];
}

describe("pages of several runs", () => {
  test("hold any number of them, each with its name", async () => {
    const blocks = ["a=1", "a=2", "a=3"].flatMap((label, run) => blocksOf(run, label));
    const { runs, problems } = await loadRuns(blocks, blocks.length, () => {});
    expect(problems).toEqual([]);
    expect(runNames(runs.map((run) => new RecordedSource(run)))).toEqual(["a=1", "a=2", "a=3"]);
  });

  test("are shown without a run that was damaged, whichever it is", async () => {
    for (const broken of [0, 1, 2]) {
      const blocks = [0, 1, 2].flatMap((run) => blocksOf(run, `run ${run}`));
      blocks[6 * broken].crc = "00000000";
      const { runs, problems } = await loadRuns(blocks, blocks.length, () => {});
      expect(runs.map(({ header: { label } }) => label)).toEqual([0, 1, 2].filter((run) => run !== broken).map((run) => `run ${run}`));
      expect(problems).toEqual([expect.stringMatching(`^run ${broken + 1}: the header block is damaged`)]);
    }
  });

  test("say what is wrong when no run can be read", async () => {
    const blocks = [0, 1].flatMap((run) => blocksOf(run, "x"));
    blocks[0].crc = blocks[6].crc = "00000000";
    await expect(loadRuns(blocks, 12, () => {})).rejects.toThrow(/run 1: the header block is damaged.*run 2: the header block is damaged/);
  });

  test("without names number their runs", async () => {
    const { runs } = await loadRuns(pageBlocks(), 6, () => {});
    expect(runNames([new RecordedSource(runs[0]), new RecordedSource(runs[0])])).toEqual(["run 1", "run 2"]);
  });
});

describe("the choice of A and B", () => {
  test("is what the reader wants, and swaps the two when one is chosen to be the other", () => {
    expect(nextChoice({ a: 0, b: 1 }, { a: 0, b: 2 })).toEqual({ a: 0, b: 2 });
    expect(nextChoice({ a: 0, b: 1 }, { a: 0, b: -1 })).toEqual({ a: 0, b: -1 });
    expect(nextChoice({ a: 0, b: 1 }, { a: 1, b: 1 })).toEqual({ a: 1, b: 0 });
    expect(nextChoice({ a: 0, b: 1 }, { a: 0, b: 0 })).toEqual({ a: 1, b: 0 });
    expect(nextChoice({ a: 0, b: -1 }, { a: 0, b: 0 })).toEqual({ a: 0, b: -1 });
  });

  test("shortens names by the keys that all have, and only these", () => {
    expect(shortNames(["method.toi=ratio", "method.toi=bisection"])).toEqual(["ratio", "bisection"]);
    expect(shortNames(["a.b=1, c=[1, 2]", "a.b=2, c=x"])).toEqual(["1, [1, 2]", "2, x"]);
    expect(shortNames(["a=1", "b=1"])).toEqual(["a=1", "b=1"]);
    expect(shortNames(["run 1", "run 2"])).toEqual(["run 1", "run 2"]);
  });

  test("has eight colours, all different", () => {
    expect(new Set(Array.from({ length: 8 }, (_, i) => runColor(i))).size).toBe(8);
  });
});

describe("curves of several runs", () => {
  const curve = (times: Float64Array, values: number[]) => ({ label: "", color: "", times, values });

  test("meet on the times of all, with gaps where a run has none", () => {
    const long = Float64Array.of(0, 1, 2, 3), short = Float64Array.of(0, 1.5);
    const table = tableOf([curve(long, [1, 2, 3, 4]), curve(short, [5, 6]), curve(long, [7, 8, 9, 10])]);
    expect(table.map((column) => Array.from(column, (value) => value ?? null))).toEqual([
      [0, 1, 1.5, 2, 3], [1, 2, null, 3, 4], [5, null, 6, null, null], [7, 8, null, 9, 10],
    ]);
    expect(tableOf([curve(short, [5, 6])])).toEqual([[0, 1.5], [5, 6]]);
    expect(tableOf([])).toEqual([[]]);
  });

  test("tell their power of ten with the unit", () => {
    expect(unitText("m", -6)).toBe(" [10⁻⁶ m]");
    expect(unitText("", 0)).toBe("");
    expect(valueUnit("m", -6)).toBe(" · 10⁻⁶ m");
    expect(valueUnit("m", 0)).toBe(" m");
  });

  test("the coordinate in which a body moves most is found", () => {
    expect(widest([[5, 5], [0, -1], [2, 2.5]])).toBe(1);
  });
});

describe("audits side by side", () => {
  const audit = { scene: "x", energy: { final: 1, work: 0 }, penetration: { bodies: ["a", "b"], time: null }, warnings: ["violated: energy"], bodies: {} };

  test("an audit is a list of lines without its bodies and warnings", () => {
    expect(auditRows(audit)).toEqual([
      { name: "scene", value: "x" }, { name: "energy: final", value: 1 }, { name: "energy: work", value: 0 },
      { name: "penetration: bodies", value: ["a", "b"] }, { name: "penetration: time", value: null },
    ]);
    expect(isSound(audit)).toBe(false);
    expect(isSound({ ...audit, warnings: ["slow"] })).toBe(true);
    expect([null, 3, 0.1, ["a", "b"], "x"].map(auditText)).toEqual(["–", "3", "0.1", "a ↔ b", "x"]);
    const span = { scheme: "event-driven", begin: 0, end: 0.5, impacts: 3, end_cause: null };
    expect(auditText([span])).toBe("event-driven 0 to 0.5 s");
    expect(auditText([{ ...span, end_cause: "events crowd" }, { ...span, scheme: "time-stepping", begin: 0.5, end: 2 }])).toBe("event-driven 0 to 0.5 s (events crowd); time-stepping 0.5 to 2 s");
    expect(auditText([])).toBe("");
  });

  test("what is not as in the first run is marked, also where the shown digits are the same", () => {
    const other = { ...audit, energy: { final: 1 + 1e-12, work: 0 }, penetration: { bodies: ["a", "b"], time: 2 }, extra: 1 };
    const rows = comparedRows([audit, other, audit]);
    expect(rows.map(({ name }) => name)).toEqual([...auditRows(audit).map(({ name }) => name), "extra"]);
    const byName = new Map(rows.map((row) => [row.name, row]));
    expect(byName.get("scene")?.differs).toEqual([false, false, false]);
    expect(byName.get("energy: final")).toEqual({ name: "energy: final", isSetting: false, values: ["1", "1", "1"], differs: [false, true, false] });
    expect(byName.get("penetration: time")?.values).toEqual(["–", "2", "–"]);
    expect(byName.get("extra")?.differs).toEqual([false, true, false]);
  });
});
