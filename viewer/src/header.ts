/** What a page says once about a run (docs/page.md). Lengths in m, SI throughout; quaternions w x y z. */
export interface Header {
  format: number;
  rigor: string;
  scene: string;
  /** Name of the run, on a page with several. */
  label?: string;
  /** There, why the run could not go on. */
  stopped?: string;
  duration: number;
  step: number;
  output_interval: number;
  gravity: Vec;
  origin: Vec;
  extent: number;
  position_step: number;
  position_error: number;
  orientation_error: number;
  /** Components of quaternions up to 1/√2 are stored in so many steps. */
  orientation_parts: number;
  contact_tolerance: number;
  frames: number;
  events: number;
  series: { name: string; unit: string }[];
  bodies: BodyHeader[];
  looks: ShapeHeader[][];
  meshes: { vertices: number; triangles: number }[];
  materials: { name: string; density: number; friction: number; restitution: number }[];
  springs: { bodies: [number, number]; points: [Vec, Vec] }[];
  joints: JointHeader[];
  audit: Record<string, unknown>;
}

export type Vec = [number, number, number];
export type Quat = [number, number, number, number];

/** A joint of two bodies (-1: the world). Its place and its axes on each, in the body's frame (of the world: from 0, not from the origin). */
export interface JointHeader {
  name: string;
  type: string;
  bodies: [number, number];
  points: [Vec, Vec];
  axes: [Vec | null, Vec | null];
}

export interface BodyHeader {
  name: string;
  motion: "dynamic" | "kinematic" | "static";
  mass: number;
  moments: Vec;
  /** Of a ball about the centre of mass that holds the body; null if there is none (planes). */
  radius: number | null;
  /** Pose of the user's frame in the body frame. */
  frame: { p: Vec; q: Quat };
  /** Pose of the body frame in the world at t = 0. */
  start: { p: Vec; q: Quat };
  look: number;
}

export interface ShapeHeader {
  type: "sphere" | "box" | "capsule" | "cylinder" | "cone" | "ellipsoid" | "plane" | "convex" | "mesh";
  radius?: number;
  half_length?: number;
  half_extents?: Vec;
  radii?: Vec;
  normal?: Vec;
  offset?: number;
  mesh?: number;
  p: Vec;
  q: Quat;
  material: number;
  color: string;
}

/**
 * The shapes to draw a body with. A moving body without any is drawn as the ellipsoid that has its mass and moments:
 * a² = 5 (I2 + I3 - I1) / 2m for the axis of I1, and so on; no axis thinner than a twentieth of the longest, or of the
 * way to the farthest of its joints.
 */
export function shapesOf(header: Header, body: number): ShapeHeader[] {
  const { look, mass, moments } = header.bodies[body];
  const shapes = header.looks[look];
  if (shapes.length > 0 || mass <= 0) return shapes;
  const [a, b, c] = moments;
  const squares = [b + c - a, c + a - b, a + b - c].map((sum) => (2.5 * Math.max(0, sum)) / mass);
  const longest = Math.max(Math.sqrt(Math.max(...squares)), ...jointPoints(header, body).map((p) => Math.hypot(...p))) || 1;
  const radii = squares.map((square) => Math.max(Math.sqrt(square), 0.05 * longest)) as Vec;
  return [{ type: "ellipsoid", radii, p: [0, 0, 0], q: [1, 0, 0, 0], material: 0, color: "" }];
}

const jointPointsOf = new WeakMap<Header, Map<number, Vec[]>>();

/** Where the joints of a body are, in its frame. */
export function jointPoints(header: Header, body: number): Vec[] {
  let points = jointPointsOf.get(header);
  if (!points) {
    points = new Map();
    for (const joint of header.joints) {
      for (const side of [0, 1]) {
        const ofBody = points.get(joint.bodies[side]);
        if (ofBody) ofBody.push(joint.points[side]);
        else points.set(joint.bodies[side], [joint.points[side]]);
      }
    }
    jointPointsOf.set(header, points);
  }
  return points.get(body) ?? [];
}
