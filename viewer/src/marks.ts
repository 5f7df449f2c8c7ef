import { overlayColors, rgb, type Rgb } from "./colors";
import type { Contact } from "./contacts";
import type { Motion } from "./frames";
import { shapesOf, type Header, type Quat, type Vec } from "./header";
import { Arrows, Dots, Lines } from "./overlays";
import type { MotionEvent } from "./run";
import type { FrameSource } from "./source";
import { lastAtMost } from "./search";

/** What the reader wants to see over the bodies. */
export interface Shown {
  contacts: boolean;
  velocities: boolean;
  frames: boolean;
  inertia: boolean;
  joints: boolean;
  trails: boolean;
  penetration: boolean;
  ghost: boolean;
  shadows: boolean;
  /** Bodies in the colours of the forces that press them. */
  heat: boolean;
  /** What of it the reader has chosen. */
  chosen: Set<string>;
  /** Factor on the lengths of arrows. */
  arrowScale: number;
}

export const shownAtFirst: Shown = {
  contacts: true, velocities: false, frames: false, inertia: false, joints: true, trails: false, penetration: true, ghost: true, shadows: true, heat: false, chosen: new Set(),
  arrowScale: 1,
};

const color = Object.fromEntries(Object.entries(overlayColors).map(([name, text]) => [name, rgb(text)])) as Record<keyof typeof overlayColors, Rgb>;

/** Of runs with more contacts at a time only the bodies are drawn, until the reader asks for points and forces. */
const mostContacts = 36;

/** Puts what the reader has not chosen to what suits the run. Returns whether that changed something. */
export function suit(shown: Shown, source: FrameSource): boolean {
  const contacts = shown.chosen.has("contacts") ? shown.contacts : source.mostContacts <= mostContacts;
  if (contacts === shown.contacts) return false;
  shown.contacts = contacts;
  return true;
}

/** Contacts that overlap by more than the tolerance; among many, where steps are stiff springs, by more than a twentieth of a body's radius. */
export function overlaps(contacts: Contact[], { header, mostContacts: most }: FrameSource): Contact[] {
  const { bodies, contact_tolerance } = header;
  const radius = (body: number) => bodies[body].radius || Infinity;
  return contacts.filter(({ bodyA, bodyB, gap }) => gap < -contact_tolerance && (most <= mostContacts || gap < -0.05 * Math.min(radius(bodyA), radius(bodyB))));
}

/** More trails than these are not drawn, unless a body is selected: then its own is. */
const mostTrails = 120;
const trailFrames = 400;

/** Arrows, dots and lines for a moment of a run. */
export class Marks {
  readonly arrows: Arrows;
  readonly dots: Dots;
  /** A large ring about the deepest overlap. */
  readonly ring: Dots;
  readonly trails = new Lines();
  /** Springs and the rods of joints. */
  readonly links = new Lines();
  private readonly header: Header;
  /** About each body's centre of mass, a ball that holds it [m]; Infinity or 0 where there is none. */
  private readonly sizes: number[];
  private largestSpeed: number;
  private largestForce = 0;
  private largestImpulse: number;

  constructor(private readonly source: FrameSource, private readonly radius: number, pixel: { value: number }, ratio: { value: number }) {
    this.header = source.header;
    const body = middleRadius(this.header) || 0.05 * radius;
    this.arrows = new Arrows(pixel, 2.2 * body);
    this.dots = new Dots({ size: 0.16 * body, most: 7, bias: 0.4 * body }, pixel, ratio);
    this.ring = new Dots({ size: 0.6 * body, most: 15, bias: Infinity }, pixel, ratio);
    this.sizes = this.header.bodies.map((body, i) => body.radius || Math.max(0, ...shapesOf(this.header, i).flatMap(({ radii }) => radii ?? [])));
    this.largestSpeed = largestNorm(source.frames.velocity);
    this.largestImpulse = largestImpulse(source);
  }

  update(time: number, motion: Motion, contacts: Contact[], shown: Shown, selected: number, event: MotionEvent | undefined): void {
    const parts = [this.arrows, this.ring, this.dots, this.trails, this.links];
    for (const part of parts) part.clear();
    if (shown.contacts) this.addContacts(contacts, shown.arrowScale);
    if (shown.velocities) this.addVelocities(motion, shown.arrowScale);
    if (shown.frames) this.addFrames(motion, selected);
    if (shown.inertia) this.addInertia(motion, selected);
    if (shown.joints) this.addJoints(motion);
    if (shown.trails) this.addTrails(time, selected);
    if (event) this.addEvent(event, shown.arrowScale);
    this.addSprings(motion);
    if (shown.penetration) this.addDeepest(overlaps(contacts, this.source));
    for (const part of parts) part.commit();
  }

  private addContacts(contacts: Contact[], scale: number): void {
    for (const { force } of contacts) this.largestForce = Math.max(this.largestForce, Math.hypot(...force));
    const length = this.largestForce > 0 ? (0.3 * scale * this.radius) / this.largestForce : 0;
    for (const { point, normal, force, mode } of contacts) {
      this.dots.add(point, color[mode]);
      const along = force[0] * normal[0] + force[1] * normal[1] + force[2] * normal[2];
      if (along <= 0) continue;
      this.arrows.add(point, normal.map((n) => n * along * length), color.normal);
      const friction = force.map((f, c) => (f - along * normal[c]) * length);
      if (Math.hypot(...friction) > 1e-3 * this.radius * scale) this.arrows.add(point, friction, color[mode]);
    }
  }

  private addDeepest(contacts: Contact[]): void {
    let deepest: Contact | undefined;
    for (const contact of contacts) if (contact.gap < (deepest?.gap ?? 0)) deepest = contact;
    if (deepest) this.ring.add(deepest.point, color.penetration);
  }

  private addVelocities(motion: Motion, scale: number): void {
    // Of a live source what is fastest so far sets the scale.
    if (this.source.kind === "live") this.largestSpeed = Math.max(this.largestSpeed, largestNorm(motion.velocity));
    if (this.largestSpeed === 0) return;
    const length = (0.3 * scale * this.radius) / this.largestSpeed;
    for (const body of this.source.moving) {
      const v = vectorAt(motion.velocity, body, length);
      if (Math.hypot(...v) > 1e-3 * this.radius) this.arrows.add(vectorAt(motion.position, body), v, color.velocity);
    }
  }

  /** The user's frames: red x, green y, blue z in the palette's hues. */
  private addFrames(motion: Motion, selected: number): void {
    for (const body of this.chosen(selected)) {
      const { frame } = this.header.bodies[body];
      const size = 1.2 * Math.min(this.sizes[body] || this.radius, this.radius);
      const q = orientationAt(motion, body);
      const start = add(vectorAt(motion.position, body), turned(q, frame.p));
      const [w, x, y, z] = frame.q;
      [color.x, color.y, color.z].forEach((hue, axis) => {
        const unit: Vec = [0, 0, 0];
        unit[axis] = size;
        this.arrows.add(start, turned(q, turned([w, x, y, z], unit)), hue);
      });
    }
  }

  /** Principal axes, each as long as the radius of gyration about it is in proportion to the largest. */
  private addInertia(motion: Motion, selected: number): void {
    for (const body of this.chosen(selected)) {
      const { moments, mass } = this.header.bodies[body];
      if (mass <= 0) continue;
      const largest = Math.sqrt(Math.max(...moments));
      const q = orientationAt(motion, body);
      const center = vectorAt(motion.position, body);
      [color.x, color.y, color.z].forEach((hue, axis) => {
        const half: Vec = [0, 0, 0];
        half[axis] = (1.35 * (this.sizes[body] || this.radius) * Math.sqrt(moments[axis])) / largest;
        const arm = turned(q, half);
        this.arrows.add(center, arm, hue);
        this.arrows.add(center, arm.map((a) => -a), hue);
      });
    }
  }

  /** A rod from each moving body's centre of mass to the joint, a dot there, its axes; the line of a distance joint. */
  private addJoints(motion: Motion): void {
    for (const { type, bodies, points, axes } of this.header.joints) {
      const places = bodies.map((body, side) => this.placeOn(body, points[side], motion)) as [Vec, Vec];
      if (type === "distance") this.links.add(places[0], places[1], color.impulse);
      const arms = bodies.map((body, side) => (this.canMove(body) ? Math.hypot(...points[side]) : 0));
      bodies.forEach((body, side) => {
        if (arms[side] > 0) this.links.add(vectorAt(motion.position, body), places[side], color.impulse);
      });
      if (type !== "fixed") places.slice(0, type === "distance" ? 2 : 1).forEach((place) => this.dots.add(place, color.impulse));
      const length = Math.min(0.2 * this.radius, Math.max(...arms) || Infinity);
      axes.forEach((axis, side) => {
        if (axis === null) return;
        const direction = bodies[side] < 0 ? axis : turned(orientationAt(motion, bodies[side]), axis);
        this.arrows.add(places[side], direction.map((x) => length * x), color.impulse);
      });
    }
  }

  private addTrails(time: number, selected: number): void {
    const { frames, frameTimes } = this.source;
    const n = frames.moving.length;
    const last = lastAtMost(frameTimes, time);
    const first = Math.max(0, last - trailFrames);
    const stride = Math.max(1, Math.floor((Math.min(n, mostTrails) * (last - first)) / 40000));
    frames.moving.forEach((body, i) => {
      if (selected >= 0 && frames.moving.includes(selected) ? body !== selected : i >= mostTrails) return;
      const at = (k: number) => frames.position.subarray(3 * (k * n + i), 3 * (k * n + i) + 3);
      for (let k = last; k > first; k -= stride) {
        const fade = 0.25 + (0.75 * (k - first)) / (last - first);
        this.trails.add(at(Math.max(first, k - stride)), at(k), color.normal.map((c) => c * fade) as Rgb);
      }
    });
  }

  /** The impulse on B from where the bodies met, and the opposite one on A. */
  private addEvent(event: MotionEvent, scale: number): void {
    if (event.kind !== "impact") return;
    if (this.source.kind === "live") this.largestImpulse = largestImpulse(this.source);
    const place = event.point.map((x, c) => x - this.header.origin[c]);
    const length = this.largestImpulse > 0 ? (0.4 * scale * this.radius) / this.largestImpulse : 0;
    const least = (0.1 * this.radius) / (Math.hypot(...event.impulse) || 1);
    const drawn = event.impulse.map((j) => j * Math.max(length, least));
    this.arrows.add(place, drawn, color.impulse);
    this.arrows.add(place, drawn.map((j) => -j), color.impulse);
    this.dots.add(place, color.impulse);
  }

  private addSprings(motion: Motion): void {
    for (const { bodies, points } of this.header.springs) {
      const [from, to] = bodies.map((body, i) => this.placeOn(body, points[i], motion));
      this.links.add(from, to, color.velocity);
    }
  }

  /** A point of a body, or of the world (-1), as the picture has it. */
  private placeOn(body: number, point: Vec, motion: Motion): Vec {
    if (body < 0) return point.map((x, c) => x - this.header.origin[c]) as Vec;
    return add(vectorAt(motion.position, body), turned(orientationAt(motion, body), point));
  }

  private canMove(body: number): boolean {
    return body >= 0 && this.header.bodies[body].motion !== "static";
  }

  /** The selected body, or all that move if none is (not so many that nothing could be made out). */
  private chosen(selected: number): number[] {
    return selected >= 0 ? [selected] : this.source.moving.slice(0, 500);
  }
}

export function vectorAt(values: ArrayLike<number>, body: number, scale = 1): Vec {
  return [values[3 * body] * scale, values[3 * body + 1] * scale, values[3 * body + 2] * scale];
}
export function orientationAt(motion: Motion, body: number): Quat {
  const q = motion.orientation;
  return [q[4 * body + 3], q[4 * body], q[4 * body + 1], q[4 * body + 2]];
}
export function add(a: Vec, b: Vec): Vec {
  return [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
}
/** R(q) v, q as w x y z. */
export function turned([w, x, y, z]: Quat, v: Vec): Vec {
  const tx = 2 * (y * v[2] - z * v[1]), ty = 2 * (z * v[0] - x * v[2]), tz = 2 * (x * v[1] - y * v[0]);
  return [v[0] + w * tx + y * tz - z * ty, v[1] + w * ty + z * tx - x * tz, v[2] + w * tz + x * ty - y * tx];
}

/** Radius of the middle one of the bodies that move, by size [m]; 0 if none has a size. */
function middleRadius({ bodies }: Header): number {
  const radii = bodies.flatMap(({ motion, radius }) => (motion === "static" || !radius || !Number.isFinite(radius) ? [] : [radius])).sort((a, b) => a - b);
  return radii[radii.length >> 1] ?? 0;
}

/**
 * For each body the forces that press it at its contacts, each with its normal part [N]; `hottest`: more than all but a fiftieth of
 * those that are pressed have.
 */
export function pressing(bodies: number, contacts: Contact[]): { forces: Float32Array; hottest: number } {
  const forces = new Float32Array(bodies);
  for (const { bodyA, bodyB, force, normal } of contacts) {
    const along = Math.max(0, force[0] * normal[0] + force[1] * normal[1] + force[2] * normal[2]);
    forces[bodyA] += along;
    forces[bodyB] += along;
  }
  const pressed = forces.filter((force) => force > 0).sort();
  return { forces, hottest: pressed[Math.floor(0.98 * (pressed.length - 1))] ?? 0 };
}

function largestImpulse({ events }: FrameSource): number {
  return events.reduce((most, event) => Math.max(most, Math.hypot(...event.impulse)), 0);
}

function largestNorm(vectors: Float32Array): number {
  let most = 0;
  for (let i = 0; i < vectors.length; i += 3) most = Math.max(most, Math.hypot(vectors[i], vectors[i + 1], vectors[i + 2]));
  return most;
}
