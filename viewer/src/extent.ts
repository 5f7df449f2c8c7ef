import type { Frames } from "./frames";
import { jointPoints, shapesOf, type Header, type Quat, type Vec } from "./header";
import { add, turned } from "./marks";
import type { Mesh } from "./run";

/** A box about what is worth looking at, from Header.origin [m]. */
export interface Extent {
  center: Vec;
  /** Half of its edges. */
  half: Vec;
  /** Half of its diagonal. */
  radius: number;
}

/**
 * Where the moving bodies go in all frames, each with its size; but no larger than 60 times the middle body's radius or three
 * times where they begin, so that bodies stay large enough to be seen. What stands still and is not much larger belongs to it: a bowl, a
 * frame, a table.
 */
export function extentOf(header: Header, frames: Frames, meshes: Mesh[]): Extent {
  const n = frames.moving.length;
  const halves = frames.moving.map((body, i) => {
    const q = new Float32Array(4);
    frames.orientation(0, i, q, 0);
    return halfExtents(header, meshes, body, [q[3], q[0], q[1], q[2]]);
  });
  const radii = halves.map((half) => Math.hypot(...half)).sort((a, b) => a - b);
  const middle = radii[n >> 1] ?? 0;
  const start = boxOf(frames, halves, 0, 1);
  const stride = Math.max(1, Math.floor(frames.count / 400));
  const all = boxOf(frames, halves, 0, frames.count, stride);
  const most = Math.max(60 * middle, 3 * start.radius);
  if (n > 0 && all.radius > 0) return all.radius <= most ? withStanding(all, header, meshes) : { center: start.center, half: [most / 2, most / 2, most / 2], radius: most };
  return standing(header);
}

/** Adds the bodies that stand still, as long as the box stays within so many times its radius. */
function withStanding(moving: Extent, header: Header, meshes: Mesh[]): Extent {
  const most = 2.5 * moving.radius;
  let lower = moving.center.map((x, c) => x - moving.half[c]), upper = moving.center.map((x, c) => x + moving.half[c]);
  header.bodies.forEach(({ motion, start }, body) => {
    if (motion !== "static") return;
    const own = boundsOf(header, meshes, body, start.q);
    if (Math.hypot(...own.lower, ...own.upper) === 0) return;
    const at = start.p.map((x, c) => x - header.origin[c]);
    const low = lower.map((x, c) => Math.min(x, at[c] + own.lower[c])), high = upper.map((x, c) => Math.max(x, at[c] + own.upper[c]));
    if (Math.hypot(...high.map((x, c) => x - low[c])) / 2 <= most) [lower, upper] = [low, high];
  });
  return boxBetween(lower, upper);
}

/** Half of a body's extent along the axes of the world when it is turned so, of those shapes that have an end, and to its joints. */
function halfExtents(header: Header, meshes: Mesh[], body: number, q: Quat): Vec {
  const { lower, upper } = boundsOf(header, meshes, body, q);
  const half = lower.map((x, c) => Math.max(-x, upper[c])) as Vec;
  for (const point of jointPoints(header, body)) turned(q, point).forEach((x, c) => (half[c] = Math.max(half[c], Math.abs(x))));
  return half;
}

/** The box about the shapes of a body that have an end, from its centre of mass along the axes of the world. */
function boundsOf(header: Header, meshes: Mesh[], body: number, q: Quat): { lower: Vec; upper: Vec } {
  const lower: Vec = [0, 0, 0], upper: Vec = [0, 0, 0];
  const include = (middle: Vec, reach: number[]) => middle.forEach((x, c) => {
    lower[c] = Math.min(lower[c], x - reach[c]);
    upper[c] = Math.max(upper[c], x + reach[c]);
  });
  for (const shape of shapesOf(header, body)) {
    if (shape.type === "plane") continue;
    const r = shape.radius ?? 0, long = shape.half_length ?? 0;
    const own: Vec = shape.half_extents ?? shape.radii ?? [r, r, shape.type === "capsule" ? r + long : long];
    if (shape.mesh !== undefined) {
      const { vertices } = meshes[shape.mesh];
      for (let v = 0; v < vertices.length; v += 3) include(turned(q, add(shape.p, turned(shape.q, [vertices[v], vertices[v + 1], vertices[v + 2]]))), [0, 0, 0]);
      continue;
    }
    const axes = [0, 1, 2].map((axis) => turned(q, turned(shape.q, [0, 1, 2].map((c) => (c === axis ? own[c] : 0)) as Vec)));
    include(turned(q, shape.p), [0, 1, 2].map((c) => (shape.type === "sphere" ? r : Math.abs(axes[0][c]) + Math.abs(axes[1][c]) + Math.abs(axes[2][c]))));
  }
  return { lower, upper };
}

function boxOf(frames: Frames, halves: Vec[], from: number, to: number, stride = 1): Extent {
  const lower = [Infinity, Infinity, Infinity];
  const upper = [-Infinity, -Infinity, -Infinity];
  const n = frames.moving.length;
  for (let frame = from; frame < to; frame += stride) {
    for (let i = 0; i < n; ++i) {
      for (let c = 0; c < 3; ++c) {
        const x = frames.position[3 * (frame * n + i) + c];
        lower[c] = Math.min(lower[c], x - halves[i][c]);
        upper[c] = Math.max(upper[c], x + halves[i][c]);
      }
    }
  }
  return boxBetween(lower, upper);
}

function boxBetween(lower: number[], upper: number[]): Extent {
  return {
    center: lower.map((x, c) => (x + upper[c]) / 2) as Vec,
    half: lower.map((x, c) => (upper[c] - x) / 2) as Vec,
    radius: Math.hypot(...upper.map((x, c) => x - lower[c])) / 2,
  };
}

/** Of a scene where nothing moves: about its bodies. */
function standing(header: Header): Extent {
  const reach = header.bodies.map((body) => Math.hypot(...body.start.p.map((x, c) => x - header.origin[c])) + (body.radius ?? 0));
  const radius = Math.max(0, ...reach.filter(Number.isFinite)) || 1;
  return { center: [0, 0, 0], half: [radius, radius, radius], radius };
}
