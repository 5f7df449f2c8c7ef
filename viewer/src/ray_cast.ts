import type { BufferGeometry } from "three";
import { drawnShape, makeGeometry } from "./geometry";
import type { ShapeHeader, Vec } from "./header";
import { turned } from "./marks";
import type { Mesh } from "./run";

/** Points from + s direction, s > 0; direction of length 1. */
export interface Line {
  from: Vec;
  direction: Vec;
}

const minus = (a: Vec, b: Vec): Vec => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const cross = (a: Vec, b: Vec): Vec => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const dot = (a: Vec, b: Vec): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** How far along a line in the body frame it first meets the drawn shapes of the body [m], or undefined. Planes are left out. */
export function distanceToShapes(line: Line, shapes: ShapeHeader[], meshes: Mesh[]): number | undefined {
  let nearest = Infinity;
  for (const shape of shapes) {
    const [w, x, y, z] = shape.q;
    const inverse: [number, number, number, number] = [w, -x, -y, -z];
    const own = { from: turned(inverse, minus(line.from, shape.p)), direction: turned(inverse, line.direction) };
    nearest = Math.min(nearest, distanceToShape(own, shape, meshes));
  }
  return Number.isFinite(nearest) ? nearest : undefined;
}

const kept = new WeakMap<Mesh[], Map<string, BufferGeometry>>();

/** The geometry of a key, made once for the meshes of a run. */
function keptGeometry(key: string, meshes: Mesh[]): BufferGeometry {
  const known = kept.get(meshes) ?? new Map<string, BufferGeometry>();
  kept.set(meshes, known);
  const geometry = known.get(key) ?? makeGeometry(key, meshes);
  known.set(key, geometry);
  return geometry;
}

function distanceToShape(line: Line, shape: ShapeHeader, meshes: Mesh[]): number {
  const { key, scale } = drawnShape(shape);
  if (key === "plane") return Infinity;
  if (key === "sphere") return distanceToBall(line, scale[0]);
  if (key === "box") return distanceToBox(line, scale);
  const geometry = keptGeometry(key, meshes);
  const position = geometry.getAttribute("position");
  const index = geometry.index;
  const corner = (k: number): Vec => {
    const i = index ? index.getX(k) : k;
    return [position.getX(i) * scale[0], position.getY(i) * scale[1], position.getZ(i) * scale[2]];
  };
  let nearest = Infinity;
  const count = index ? index.count : position.count;
  for (let k = 0; k < count; k += 3) nearest = Math.min(nearest, distanceToTriangle(line, corner(k), corner(k + 1), corner(k + 2)));
  geometry.dispose();
  return nearest;
}

/** Of the ball about the origin: |from + s d|² = r², the smaller s. */
function distanceToBall({ from, direction }: Line, r: number): number {
  const b = dot(from, direction);
  const under = b * b - dot(from, from) + r * r;
  const s = -b - Math.sqrt(under);
  return s > 0 ? s : Infinity;
}

/** Between the three pairs of planes at once. */
function distanceToBox({ from, direction }: Line, half: Vec): number {
  let enter = 0, leave = Infinity;
  for (let c = 0; c < 3; ++c) {
    const a = (-half[c] - from[c]) / direction[c], b = (half[c] - from[c]) / direction[c];
    if (Number.isNaN(a) || Number.isNaN(b)) continue; // in a face's plane and along it
    enter = Math.max(enter, Math.min(a, b));
    leave = Math.min(leave, Math.max(a, b));
  }
  return enter > 0 && enter <= leave ? enter : Infinity;
}

/** Source: Möller and Trumbore, Fast, Minimum Storage Ray/Triangle Intersection, J. Graphics Tools 2(1), 1997. Both sides count. */
function distanceToTriangle({ from, direction }: Line, a: Vec, b: Vec, c: Vec): number {
  const ab = minus(b, a), ac = minus(c, a);
  const p = cross(direction, ac);
  const determinant = dot(ab, p);
  const t = minus(from, a), q = cross(t, ab);
  const u = dot(t, p) / determinant, v = dot(direction, q) / determinant, s = dot(ac, q) / determinant;
  return u >= 0 && v >= 0 && u + v <= 1 && s > 0 ? s : Infinity;
}
