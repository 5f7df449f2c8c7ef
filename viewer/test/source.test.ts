import { describe, expect, test } from "vitest";
import { makeMotion } from "../src/frames";
import { loadRuns } from "../src/run";
import { cubic, RecordedSource, throughImpact } from "../src/source";
import { pageBlocks } from "./bytes";

describe("motion between frames", () => {
  test("a free flight is followed exactly", () => {
    // x = 3 + 4 t - 5 t², of which the cubic through two frames is the parabola itself.
    const x = (t: number) => 3 + 4 * t - 5 * t * t, v = (t: number) => 4 - 10 * t;
    for (const s of [0, 0.1, 0.37, 0.5]) expect(cubic(x(0), v(0), x(0.5), v(0.5), 0.5, s)).toBeCloseTo(x(s), 12);
  });

  test("over an impact the body reaches the point where it was struck", () => {
    // Falls at 2 m/s from 0.6 to 0 in 0.3 s, leaves at 1 m/s.
    const at = (s: number) => throughImpact(0.6, -2, 0.2, 1, 0.5, s, 0.3, 0.3);
    expect(at(0)).toBeCloseTo(0.6, 12);
    expect(at(0.15)).toBeCloseTo(0.3, 12);
    expect(at(0.3)).toBeCloseTo(0, 12);
    expect(at(0.4)).toBeCloseTo(0.1, 12);
    expect(at(0.5)).toBeCloseTo(0.2, 12);
  });

  test("between two impacts of an interval it goes straight", () => {
    const at = (s: number) => throughImpact(1, -1, 2, 1, 1, s, 0.25, 0.75);
    expect(at(0.25)).toBeCloseTo(0.75, 12);
    expect(at(0.75)).toBeCloseTo(1.75, 12);
    expect(at(0.5)).toBeCloseTo(1.25, 12);
  });
});

describe("a recorded source", () => {
  const sourceOf = async () => new RecordedSource((await loadRuns(pageBlocks(), 6, () => {})).runs[0]);

  test("gives stored frames as they are, and static bodies where they stand", async () => {
    const source = await sourceOf();
    const motion = makeMotion(2);
    source.sample(0.5, motion);
    expect([...motion.position]).toEqual([-9, 2, 3, 2, 0, 0]);
    expect([...motion.orientation.slice(0, 4)]).toEqual([1, 0, 0, 0]);
    expect([...motion.velocity.slice(3)]).toEqual([2, 0, -2]);
  });

  test("holds its first and last frame outside its times", async () => {
    const source = await sourceOf();
    const motion = makeMotion(2);
    source.sample(-3, motion);
    expect(motion.position[3]).toBe(1);
    source.sample(9, motion);
    expect(motion.position[3]).toBe(3);
  });

  test("takes a body to where it was at the first and at the last of several impacts", async () => {
    const { runs } = await loadRuns(pageBlocks(), 6, () => {});
    const impact = runs[0].events[0];
    runs[0].events = [0.1, 0.2, 0.3].map((time) => ({ ...impact, time }));
    runs[0].frames.velocity[1] = 1;
    const source = new RecordedSource(runs[0]);
    const motion = makeMotion(2);
    // y leaves 0 at 1 m/s and comes to 0 at rest.
    for (const [time, y] of [[0.05, 0.05], [0.1, 0.1], [0.2, 0.05], [0.3, 0], [0.4, 0]]) {
      source.sample(time, motion);
      expect(motion.position[4]).toBeCloseTo(y, 6);
    }
  });

  test("goes on between frames with the stored velocities", async () => {
    const source = await sourceOf();
    const motion = makeMotion(2);
    source.sample(0.25, motion);
    // z: 1 and 0 with velocity -2 at both ends is a straight line; so is x.
    expect(motion.position[3]).toBeCloseTo(1.5, 6);
    expect(motion.position[5]).toBeCloseTo(0.5, 6);
  });
});
