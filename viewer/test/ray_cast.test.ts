import { describe, expect, test } from "vitest";
import type { ShapeHeader, Vec } from "../src/header";
import { distanceToShapes } from "../src/ray_cast";
import type { Mesh } from "../src/run";

const shape = (own: Partial<ShapeHeader>): ShapeHeader => ({ type: "box", p: [0, 0, 0], q: [1, 0, 0, 0], material: 0, color: "", ...own });
const down = (x: number, y: number): { from: Vec; direction: Vec } => ({ from: [x, y, 10], direction: [0, 0, -1] });
const hit = (x: number, y: number, own: Partial<ShapeHeader>, meshes: Mesh[] = []) => distanceToShapes(down(x, y), [shape(own)], meshes);

describe("where a line of sight meets a body", () => {
  test("a ball: at the height √(r² - x²)", () => {
    expect(hit(0.6, 0, { type: "sphere", radius: 1 })).toBeCloseTo(10 - 0.8, 12);
    expect(hit(1.01, 0, { type: "sphere", radius: 1 })).toBeUndefined();
  });

  test("a box: on its top, also along its side and off its middle", () => {
    expect(hit(0.5, -1.5, { half_extents: [1, 2, 3] })).toBeCloseTo(7, 12);
    expect(hit(1.5, 0, { half_extents: [1, 2, 3] })).toBeUndefined();
    expect(hit(0.5, 0, { half_extents: [1, 2, 3], p: [0, 0, 1] })).toBeCloseTo(6, 12);
  });

  test("a turned box: on its edge", () => {
    // An eighth of a turn about x: a cube of half side 1 reaches up to √2.
    const q: [number, number, number, number] = [Math.cos(Math.PI / 8), Math.sin(Math.PI / 8), 0, 0];
    expect(hit(0, 0, { half_extents: [1, 1, 1], q })).toBeCloseTo(10 - Math.SQRT2, 12);
  });

  test("round shapes: on what is drawn of them, close to their surface", () => {
    expect(hit(0.3, 0.2, { type: "cylinder", radius: 1, half_length: 2 })).toBeCloseTo(8, 9);
    expect(hit(0, 0, { type: "capsule", radius: 1, half_length: 2 })).toBeCloseTo(7, 6);
    // The cone's side is at the half of its height where its radius is the half.
    expect(hit(0.5, 0, { type: "cone", radius: 1, half_length: 2 })).toBeCloseTo(10, 1);
    expect(hit(1, 0, { type: "ellipsoid", radii: [2, 1, 3] })).toBeCloseTo(10 - 3 * Math.sqrt(0.75), 1);
  });

  test("a mesh: in the plane of the triangle, from both sides", () => {
    const meshes = [{ vertices: Float32Array.from([0, 0, 0, 2, 0, 1, 0, 2, 0]), triangles: Uint32Array.from([0, 1, 2]) }];
    expect(hit(1, 0.5, { type: "mesh", mesh: 0 }, meshes)).toBeCloseTo(9.5, 6);
    expect(hit(1.5, 1, { type: "mesh", mesh: 0 }, meshes)).toBeUndefined();
  });

  test("of several shapes the nearest, behind the eye none", () => {
    const ball = shape({ type: "sphere", radius: 1 }), higher = shape({ type: "sphere", radius: 1, p: [0, 0, 3] });
    expect(distanceToShapes(down(0, 0), [ball, higher], [])).toBeCloseTo(6, 12);
    expect(distanceToShapes({ from: [0, 0, 10], direction: [0, 0, 1] }, [ball, shape({ half_extents: [1, 1, 1] })], [])).toBeUndefined();
  });
});
