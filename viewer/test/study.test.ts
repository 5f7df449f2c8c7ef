import { describe, expect, test } from "vitest";
import { readStudy, replayOf, shareOf, ticks } from "../src/study/data";
import { distanceTo } from "../src/study/parallel";
import { Selection, summary } from "../src/study/selection";

const written = {
  name: "slides", file: "my studies/slides.yaml", total: 40, runs: [0, 10, 20, 30], status: [0, 0, 2, 1],
  statuses: ["done", "violated", "stopped"], reasons: { 20: "stopped at t = 1 s" }, main: "distance", kept: null,
  columns: [
    { name: "mu", parameter: true, values: [0.1, 0.2, 0.3, 0.4] },
    { name: "distance", parameter: false, values: [8, 4, null, 2] },
    { name: "unknown", parameter: false, values: [null, null, null, null] },
  ],
};
const read = (change = {}, token: string | null = null) => readStudy(JSON.stringify({ ...written, ...change }), token);

describe("data of a study's page", () => {
  test("columns know their range, and those without a number are left out", () => {
    const study = read();
    expect(study.columns.map(({ name, low, high }) => [name, low, high])).toEqual([["mu", 0.1, 0.4], ["distance", 2, 8]]);
    expect(study.main).toBe(1);
    expect(study.columns[1].values[2]).toBeNaN();
    expect(study.status).toEqual(["done", "done", "stopped", "violated"]);
  });

  test("shares lie between the ends, and in the middle where all are equal", () => {
    const [mu] = read().columns;
    expect(shareOf(mu, 0.1)).toBe(0);
    expect(shareOf(mu, 0.4)).toBe(1);
    expect(shareOf({ ...mu, low: 2, high: 2 }, 2)).toBe(0.5);
  });

  test("ticks are round and within the range, at any size", () => {
    expect(ticks(0, 1, 5)).toEqual([0, 0.2, 0.4, 0.6000000000000001, 0.8, 1]);
    let seed = 1;
    const random = () => (seed = (48271 * seed) % 2147483647) / 2147483647;
    for (let i = 0; i < 200; ++i) {
      const low = (random() - 0.5) * 10 ** (20 * random() - 10), high = low + 10 ** (20 * random() - 10);
      if (!(high > low)) continue;
      const marks = ticks(low, high, 6);
      expect(marks.length).toBeLessThanOrEqual(9);
      expect(marks.length).toBeGreaterThan(0);
      for (const mark of marks) expect(mark >= low - 1e-9 * (high - low) && mark <= high + 1e-9 * (high - low)).toBe(true);
    }
  });

  test("a run is replayed by the server, from a file, or by a command", () => {
    expect(replayOf(read({}, "abc"), 20)).toEqual({ address: "/run/20?token=abc" });
    expect(replayOf(read({ kept: "slides_runs" }), 20)).toEqual({ address: "slides_runs/run_20.html" });
    expect(replayOf(read(), 20)).toEqual({ command: "rigor study 'my studies/slides.yaml' --run 20 -o run_20.html" });
  });
});

describe("selection", () => {
  test("ranges keep runs, those with an unknown value are in none", () => {
    const study = read(), selection = new Selection(study);
    expect(summary(study, selection)).toEqual({ count: 4, mean: 14 / 3 });
    let told = 0;
    selection.listen(() => ++told);
    selection.limit(1, [2, 5]);
    expect([0, 1, 2, 3].map((run) => selection.holds(run))).toEqual([false, true, false, true]);
    expect(summary(study, selection)).toEqual({ count: 2, mean: 3 });
    selection.clear();
    expect(selection.holds(2)).toBe(true);
    expect(told).toBe(2);
  });

  test("distance from a line ends at its ends", () => {
    expect(distanceTo({ x: 5, y: 3 }, { x: 0, y: 0 }, { x: 10, y: 0 })).toBe(3);
    expect(distanceTo({ x: 13, y: 4 }, { x: 0, y: 0 }, { x: 10, y: 0 })).toBe(5);
    expect(distanceTo({ x: 0, y: 0 }, { x: 0, y: NaN }, { x: 10, y: 0 })).toBe(Infinity);
  });
});
