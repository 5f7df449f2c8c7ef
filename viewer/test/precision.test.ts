import { describe, expect, test } from "vitest";
import { logAxis, placeOn, referenceError, shownPoints, type PrecisionPoint } from "../src/precision";
import { loadRuns } from "../src/run";
import { blockOf, pageBlocks } from "./bytes";

const point = (step: number, error: number): PrecisionPoint => ({ label: `run.step=${step}`, step, cpu_time: 1 / step, error, order: null });

describe("a logarithmic axis", () => {
  test("has whole decades that hold all values", () => {
    expect(logAxis([0.02, 3])).toEqual({ low: -2, high: 1, ticks: [-2, -1, 0, 1] });
    expect(logAxis([1e-12, 1])).toEqual({ low: -12, high: 0, ticks: [-12, -10, -8, -6, -4, -2, 0] });
  });

  test("begins and ends at values that are decades themselves", () => {
    expect(logAxis([0.01, 0.001])).toEqual({ low: -3, high: -2, ticks: [-3, -2] });
    expect(logAxis([0.01, 0.01])).toEqual({ low: -2, high: -1, ticks: [-2, -1] });
  });

  test("stands without values too, and takes no notice of what has no logarithm", () => {
    expect(logAxis([])).toEqual({ low: -1, high: 0, ticks: [-1, 0] });
    expect(logAxis([0, -1, NaN, Infinity, 0.5])).toEqual({ low: -1, high: 0, ticks: [-1, 0] });
  });

  test("places values by their logarithm", () => {
    const axis = logAxis([0.01, 1]);
    expect(placeOn(axis, 0.01)).toBe(0);
    expect(placeOn(axis, 1)).toBe(1);
    expect(placeOn(axis, 0.1)).toBeCloseTo(0.5, 14);
  });
});

describe("work and precision", () => {
  test("leave out what has no error", () => {
    const curve = { label: "", points: [point(0.1, 1e-3), point(0.05, 0), point(0.02, 1e-5)] };
    expect(shownPoints(curve, ({ step }) => step).map(({ step }) => step)).toEqual([0.1, 0.02]);
    expect(shownPoints(curve, () => 0)).toEqual([]);
  });

  test("know the largest error of the references, if any has one", () => {
    const of = (...errors: (number | null)[]) => referenceError({ references: errors.map((error) => ({ name: "", error })), curves: [] });
    expect(of(1e-9, null, 1e-7)).toBe(1e-7);
    expect(of(0, null)).toBeUndefined();
  });

  test("come with the page, or are told to be damaged", async () => {
    const precision = { references: [{ name: "r", error: null }], curves: [{ label: "", points: [point(0.1, 1e-3)] }] };
    const block = blockOf("precision", new TextEncoder().encode(JSON.stringify(precision)), 0);
    const whole = await loadRuns([...pageBlocks(), block], 7, () => {});
    expect(whole.precision).toEqual(precision);
    expect(whole.problems).toEqual([]);
    expect((await loadRuns(pageBlocks(), 6, () => {})).precision).toBeUndefined();
    const broken = await loadRuns([...pageBlocks(), { ...block, crc: "00000000" }], 7, () => {});
    expect(broken.precision).toBeUndefined();
    expect(broken.problems).toEqual([expect.stringMatching("^the precision block is damaged.*left out$")]);
  });
});
