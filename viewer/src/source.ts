import type { Contact } from "./contacts";
import type { Frames, Motion, MotionTable } from "./frames";
import type { Header } from "./header";
import type { Mesh, MotionEvent, Run } from "./run";
import { lastAtMost } from "./search";

/**
 * Where the viewer gets motion from: a recorded run, or (with `rigor view`) a live one that sends its newest frame.
 * The views ask for a time and draw what they get; they do not know which of the two it is.
 */
export interface FrameSource {
  readonly kind: "recorded" | "live";
  readonly header: Header;
  readonly meshes: Mesh[];
  /** Times of the series [s], ascending. */
  readonly times: Float64Array;
  readonly series: Map<string, Float64Array>;
  readonly events: MotionEvent[];
  /** Model indices of the bodies that are not static. */
  readonly moving: number[];
  /** The motion for trails and plots; a live source keeps what the page has seen, thinned where that is much. */
  readonly frames: MotionTable;
  /** Times of `frames` [s]: those of the series, or in a live source its own. */
  readonly frameTimes: Float64Array;
  /** Fills in the motion of all bodies at a time [s], held within the times there are. */
  sample(time: number, into: Motion): void;
  /** Contacts of the last frame that is not after the time. */
  contactsAt(time: number): Contact[];
  /** Contacts of the frame that has most of them, as far as frames are known. */
  readonly mostContacts: number;
  /** Called when a live source has a new frame; recorded ones never call. */
  onFrame?: () => void;
}

/**
 * A stored run. Between two frames a body follows the cubic that has the stored positions and velocities at both ends;
 * over an impact it follows two parabolas that meet at the impact, so that bodies touch where they touched.
 */
export class RecordedSource implements FrameSource {
  readonly kind = "recorded";
  /** For each frame: impacts until the next one, by moving body, as their first and last times. */
  private readonly impacts = new Map<number, Map<number, [number, number]>>();

  constructor(private readonly run: Run) {
    const place = new Map(run.frames.moving.map((body, i) => [body, i]));
    for (const event of run.events) {
      if (event.kind !== "impact") continue;
      const frame = lastAtMost(run.times, event.time);
      const ofFrame = this.impacts.get(frame) ?? new Map<number, [number, number]>();
      this.impacts.set(frame, ofFrame);
      for (const body of [event.bodyA, event.bodyB]) {
        const i = place.get(body);
        if (i !== undefined) ofFrame.set(i, [ofFrame.get(i)?.[0] ?? event.time, event.time]);
      }
    }
  }

  get header(): Header {
    return this.run.header;
  }
  get meshes(): Mesh[] {
    return this.run.meshes;
  }
  get times(): Float64Array {
    return this.run.times;
  }
  get series(): Map<string, Float64Array> {
    return this.run.series;
  }
  get events(): MotionEvent[] {
    return this.run.events;
  }
  get moving(): number[] {
    return this.run.frames.moving;
  }
  get frames(): Frames {
    return this.run.frames;
  }
  get frameTimes(): Float64Array {
    return this.run.times;
  }

  get mostContacts(): number {
    return this.run.contacts.most;
  }

  contactsAt(time: number): Contact[] {
    return this.run.contacts.at(lastAtMost(this.run.times, time));
  }

  sample(time: number, into: Motion): void {
    const { times, frames, header } = this.run;
    const k = lastAtMost(times, time);
    const next = Math.min(k + 1, times.length - 1);
    const h = times[next] - times[k];
    const s = h > 0 ? Math.min(Math.max(time - times[k], 0), h) : 0;
    const impacts = this.impacts.get(k);
    const n = frames.moving.length;
    header.bodies.forEach((body, i) => {
      if (body.motion === "static") setStatic(body.start.p, body.start.q, header.origin, i, into);
    });
    for (let i = 0; i < n; ++i) {
      const body = frames.moving[i];
      const impact = s > 0 && s < h ? impacts?.get(i) : undefined;
      const a = 3 * (k * n + i);
      const b = 3 * (next * n + i);
      for (let c = 0; c < 3; ++c) {
        const x0 = frames.position[a + c], x1 = frames.position[b + c];
        const v0 = frames.velocity[a + c], v1 = frames.velocity[b + c];
        into.position[3 * body + c] = impact
          ? throughImpact(x0, v0, x1, v1, h, s, impact[0] - times[k], impact[1] - times[k])
          : s > 0 ? cubic(x0, v0, x1, v1, h, s) : x0;
        const early = impact ? s < impact[1] - times[k] : s < h;
        const blend = impact ? (early ? 0 : 1) : h > 0 ? s / h : 0;
        into.velocity[3 * body + c] = v0 + blend * (v1 - v0);
        into.spin[3 * body + c] = frames.spin[a + c] + blend * (frames.spin[b + c] - frames.spin[a + c]);
      }
      frames.orientation(k, i, into.orientation, 4 * body);
      if (s > 0) {
        frames.orientation(next, i, scratch, 0);
        blendQuaternion(into.orientation, 4 * body, scratch, s / h);
      }
    }
  }
}

const scratch = new Float32Array(4);

function setStatic(p: ArrayLike<number>, q: ArrayLike<number>, origin: ArrayLike<number>, body: number, into: Motion): void {
  for (let c = 0; c < 3; ++c) {
    into.position[3 * body + c] = p[c] - origin[c];
    into.orientation[4 * body + c] = q[c + 1];
  }
  into.orientation[4 * body + 3] = q[0];
}

/** Hermite's cubic with values x0, x1 and slopes v0, v1 at 0 and h. */
export function cubic(x0: number, v0: number, x1: number, v1: number, h: number, s: number): number {
  const u = s / h;
  const w = 1 - u;
  return w * w * ((1 + 2 * u) * x0 + s * v0) + u * u * ((1 + 2 * w) * x1 - (h - s) * v1);
}

/** From the left frame on a parabola to the first impact, straight to the last one, on a parabola to the right frame. */
export function throughImpact(x0: number, v0: number, x1: number, v1: number, h: number, s: number, first: number, last: number): number {
  const before = x0 + v0 * first;
  const after = x1 - v1 * (h - last);
  // Of one impact the two estimates are of the same point.
  const xFirst = first === last ? (before + after) / 2 : before;
  const xLast = first === last ? xFirst : after;
  if (s <= first) return parabola(x0, v0, xFirst, first, s);
  if (s >= last) return parabola(x1, -v1, xLast, h - last, h - s);
  return xFirst + ((xLast - xFirst) * (s - first)) / (last - first);
}

/** Value x0 and slope v0 at 0, value x1 at h. */
function parabola(x0: number, v0: number, x1: number, h: number, s: number): number {
  return h > 0 ? x0 + v0 * s + (x1 - x0 - v0 * h) * (s / h) ** 2 : x1;
}

/** Goes the part u of the shorter way to q, along the chord. */
function blendQuaternion(into: Float32Array, at: number, q: Float32Array, u: number): void {
  let dot = 0;
  for (let c = 0; c < 4; ++c) dot += into[at + c] * q[c];
  const sign = dot < 0 ? -1 : 1;
  let norm = 0;
  for (let c = 0; c < 4; ++c) {
    into[at + c] += u * (sign * q[c] - into[at + c]);
    norm += into[at + c] ** 2;
  }
  norm = 1 / Math.sqrt(norm);
  for (let c = 0; c < 4; ++c) into[at + c] *= norm;
}
