import { describe, expect, test } from "vitest";
import { extentOf } from "../src/extent";
import type { Header, JointHeader } from "../src/header";
import { jointPoints, shapesOf } from "../src/header";
import { makeMotion } from "../src/frames";
import { Marks, shownAtFirst } from "../src/marks";
import { loadRuns } from "../src/run";
import { RecordedSource } from "../src/source";
import { header, pageBlocks } from "./bytes";

/** A ball on a rod of 3 m: the joint is above it, in the world at (10, 0, 4). */
const pivot: JointHeader = { name: "pivot", type: "hinge", bodies: [-1, 1], points: [[10, 0, 4], [0, 0, 3]], axes: [[0, 1, 0], null] };
const string: JointHeader = { name: "string", type: "distance", bodies: [0, 1], points: [[0, 0, 0], [0, 0, 0]], axes: [null, null] };
const withJoints = (...joints: JointHeader[]): Header => ({ ...header, joints });

async function marksOf(joints: JointHeader[], shown = shownAtFirst) {
  const { runs } = await loadRuns(pageBlocks(), 6, () => {});
  const source = new RecordedSource({ ...runs[0], header: withJoints(...joints) });
  const marks = new Marks(source, 10, { value: 1 }, { value: 1 });
  const motion = makeMotion(2);
  source.sample(0, motion);
  marks.update(0, motion, [], shown, -1, undefined);
  return marks;
}
const numbers = (geometry: { getAttribute(name: string): { array: ArrayLike<number> } }, name: string, count: number) =>
  Array.from(geometry.getAttribute(name).array).slice(0, count);

describe("joints", () => {
  test("are found by the body that they are on", () => {
    expect(jointPoints(withJoints(pivot, string), 1)).toEqual([[0, 0, 3], [0, 0, 0]]);
    expect(jointPoints(withJoints(pivot), 0)).toEqual([]);
  });

  test("reach into what is worth looking at", async () => {
    const { runs } = await loadRuns(pageBlocks(), 6, () => {});
    const without = extentOf(header, runs[0].frames, []), jointed = extentOf(withJoints(pivot), runs[0].frames, []);
    // The ball is between z = 0 and 1; its ellipsoid of moments (1, 1, 1) and mass 2 has the radius √(5/4).
    expect(without.half[2]).toBeCloseTo(0.5 + Math.sqrt(1.25), 12);
    expect(jointed.half[2]).toBeCloseTo(0.5 + 3, 12);
  });

  test("what stands still is worth looking at too, unless it is much larger", async () => {
    const { runs } = await loadRuns(pageBlocks(), 6, () => {});
    const withBox = (size: number) => {
      const box = { type: "box" as const, half_extents: [size, size, size] as [number, number, number], p: [0, 0, 0] as [number, number, number], q: [1, 0, 0, 0] as [number, number, number, number], material: 0, color: "" };
      const floor = { ...header.bodies[0], start: { p: [12, 0, 0] as [number, number, number], q: header.bodies[0].start.q } };
      return extentOf({ ...header, bodies: [floor, header.bodies[1]], looks: [[box], []] }, runs[0].frames, []);
    };
    const alone = extentOf(header, runs[0].frames, []);
    // About the place 2 m from the origin along x, as far as the ball goes on.
    expect(withBox(2.5).half[1]).toBeCloseTo(2.5, 12);
    expect(withBox(2.5).radius).toBeGreaterThan(alone.radius);
    expect(withBox(50)).toEqual(alone);
  });

  test("make a body without shapes as large as a twentieth of the way to them", () => {
    const small: Header = { ...withJoints(pivot), bodies: [header.bodies[0], { ...header.bodies[1], moments: [1e-9, 1e-9, 1e-9] }] };
    expect(shapesOf(small, 1)[0].radii).toEqual([3, 3, 3].map((x) => 0.05 * x));
  });

  test("are drawn as rods from the moving bodies, a dot and an arrow along the axis", async () => {
    const marks = await marksOf([pivot]);
    // The ball is at (1, 0, 1) from the origin (10, 0, 0), the world's point at (0, 0, 4).
    expect(numbers(marks.links.lines.geometry, "position", 6)).toEqual([1, 0, 1, 1, 0, 4]);
    expect(marks.links.lines.geometry.drawRange.count).toBe(2);
    expect(numbers(marks.dots.points.geometry, "position", 3)).toEqual([0, 0, 4]);
    expect(numbers(marks.arrows.mesh.geometry, "iStart", 3)).toEqual([0, 0, 4]);
    expect(numbers(marks.arrows.mesh.geometry, "iVector", 3)).toEqual([0, 2, 0]);
  });

  test("of a distance are a line between its points", async () => {
    const marks = await marksOf([string]);
    expect(numbers(marks.links.lines.geometry, "position", 6)).toEqual([-9, 2, 3, 1, 0, 1]);
    expect(marks.links.lines.geometry.drawRange.count).toBe(2);
    expect(marks.arrows.mesh.visible).toBe(false);
  });

  test("are not drawn where they are not wanted", async () => {
    const marks = await marksOf([pivot, string], { ...shownAtFirst, joints: false });
    expect(marks.links.lines.visible).toBe(false);
    expect(marks.dots.points.visible).toBe(false);
  });
});
