import { DataError } from "./blocks";
import type { Header } from "./header";
import { Reader } from "./reader";

/** Positions count from Header.origin; orientations are x y z w. One place a body of the scene. */
export interface Motion {
  position: Float32Array;
  orientation: Float32Array;
  velocity: Float32Array;
  spin: Float32Array;
}

export function makeMotion(bodies: number): Motion {
  return {
    position: new Float32Array(3 * bodies),
    orientation: new Float32Array(4 * bodies),
    velocity: new Float32Array(3 * bodies),
    spin: new Float32Array(3 * bodies),
  };
}

/** The motion of the bodies that are not static at some times: row by row, body by body. */
export interface MotionTable {
  /** Model indices of the bodies. */
  readonly moving: number[];
  readonly position: Float32Array;
  readonly velocity: Float32Array;
  readonly spin: Float32Array;
  /** Orientation x y z w of the i-th moving body in a row. */
  orientation(row: number, i: number, into: Float32Array, at: number): void;
}

/** The stored motion of the bodies that are not static: frame by frame, body by body. */
export class Frames implements MotionTable {
  /** Model indices of the bodies that are stored. */
  readonly moving: number[];
  /** Frames that have been read. */
  count = 0;
  readonly position: Float32Array;
  readonly velocity: Float32Array;
  readonly spin: Float32Array;
  private readonly components: Int16Array;
  private readonly largest: Uint8Array;
  /** For each body its place in `moving`, or -1. */
  private readonly places: Int32Array;

  constructor(private readonly header: Header) {
    this.moving = header.bodies.flatMap((body, i) => (body.motion === "static" ? [] : [i]));
    this.places = new Int32Array(header.bodies.length).fill(-1);
    this.moving.forEach((body, i) => (this.places[body] = i));
    const size = this.moving.length * header.frames;
    this.position = new Float32Array(3 * size);
    this.velocity = new Float32Array(3 * size);
    this.spin = new Float32Array(3 * size);
    this.components = new Int16Array(3 * size);
    this.largest = new Uint8Array(size);
  }

  /** Appends a chunk: packed_frames (rigor/view/page/page_frames.hpp). */
  addChunk(bytes: Uint8Array): void {
    const reader = new Reader(bytes);
    const steps = { speed: reader.f64(), spin: reader.f64(), travel: reader.f64(), turn: reader.f64() };
    const orders = [reader.u32(), reader.u32()];
    const frames = reader.u32();
    const bodies = reader.u32();
    const n = this.moving.length;
    if (bodies !== n || this.count + frames > this.header.frames) {
      throw new DataError("a frames block does not belong to this run");
    }
    const first = this.count * n;
    // Velocities in their steps, which poses are expected from.
    const columns = (order: number) => {
      const whole = new Float64Array(3 * n * frames);
      for (let column = 0; column < 3 * n; ++column) reader.column(frames, 1, whole, column, 3 * n, order);
      return whole;
    };
    const speeds = columns(orders[0]);
    const spins = columns(orders[1]);
    for (let i = 0; i < speeds.length; ++i) {
      this.velocity[3 * first + i] = speeds[i] * steps.speed;
      this.spin[3 * first + i] = spins[i] * steps.spin;
    }
    this.addPositions(reader, frames, speeds, steps.travel);
    for (let body = 0; body < n; ++body) this.addOrientations(reader, frames, body, spins, steps.turn);
    this.count += frames;
  }

  private addPositions(reader: Reader, frames: number, speeds: Float64Array, travel: number): void {
    const n = this.moving.length;
    const first = 3 * this.count * n;
    for (let column = 0; column < 3 * n; ++column) {
      let x = 0;
      for (let k = 0, at = column; k < frames; ++k, at += 3 * n) {
        if (k > 0) x += Math.floor((travel * (speeds[at] + speeds[at - 3 * n]) + 32768) / 65536);
        x += reader.varint();
        this.position[first + at] = x * this.header.position_step;
      }
    }
    reader.checkEnd();
  }

  private addOrientations(reader: Reader, frames: number, body: number, spins: Float64Array, turn: number): void {
    const n = this.moving.length;
    const parts = this.header.orientation_parts;
    const place = this.count * n + body;
    reader.column(frames, 1, this.largest, place, n, 1);
    const residuals = [0, 1, 2].map(() => Float64Array.from({ length: frames }, () => reader.varint()));
    reader.checkEnd();
    const q = new Float64Array(4);
    const a = [0, 0, 0];
    const expected = [0, 0, 0];
    for (let k = 0; k < frames; ++k) {
      const own = place + k * n;
      if (k > 0) {
        for (let c = 0; c < 3; ++c) a[c] = (spins[3 * (k * n + body) + c] + spins[3 * ((k - 1) * n + body) + c]) * turn;
        unpackQuaternion(this.largest[own - n], this.components, 3 * (own - n), q, 0, parts);
        predictOrientation(q, a);
        expectedOthers(q, this.largest[own], parts, expected);
      }
      for (let c = 0; c < 3; ++c) this.components[3 * own + c] = residuals[c][k] + expected[c];
    }
  }

  /** Where `position` has a body in a frame that has been read; -1: it does not move. */
  place(frame: number, body: number): number {
    const i = this.places[body];
    return i < 0 || frame >= this.count ? -1 : 3 * (frame * this.moving.length + i);
  }

  /** Orientation x y z w of the i-th moving body in a frame. */
  orientation(frame: number, i: number, into: Float32Array, at: number): void {
    const place = frame * this.moving.length + i;
    unpackQuaternion(this.largest[place], this.components, 3 * place, into, at, this.header.orientation_parts);
  }
}

/** The unit quaternion x y z w of its three smaller components, each in ±parts for ±1/√2; `largest` is in w x y z. */
export function unpackQuaternion(largest: number, others: ArrayLike<number>, from: number, into: Float32Array | Float64Array, at: number, parts = 32767): void {
  const step = Math.SQRT1_2 / parts;
  let rest = 1;
  for (let i = 0, k = 0; i < 4; ++i) {
    if (i === largest) continue;
    const value = others[from + k++] * step;
    into[at + ((i + 3) & 3)] = value;
    rest -= value * value;
  }
  into[at + ((largest + 3) & 3)] = Math.sqrt(Math.max(0, rest));
}

/** Turns q (x y z w) by the rotation vector 2 a: the same operations in the same order as predicted_orientation (rigor/view/page/frame_packing.cpp). */
export function predictOrientation(q: Float64Array, a: ArrayLike<number>): void {
  const n = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
  if (!(n < 4)) return;
  const w = 1 - (n / 2) * (1 - (n / 12) * (1 - n / 30)), s = 1 - (n / 6) * (1 - (n / 20) * (1 - n / 42));
  const x = s * a[0], y = s * a[1], z = s * a[2];
  const [q1, q2, q3, q0] = q;
  q[3] = w * q0 - x * q1 - y * q2 - z * q3;
  q[0] = w * q1 + x * q0 + y * q3 - z * q2;
  q[1] = w * q2 - x * q3 + y * q0 + z * q1;
  q[2] = w * q3 + x * q2 - y * q1 + z * q0;
}

/** What is expected of the three other components of a quaternion x y z w whose largest one (in w x y z) this is. */
function expectedOthers(q: Float64Array, largest: number, parts: number, into: number[]): void {
  const sign = q[(largest + 3) & 3] < 0 ? -1 : 1, scale = parts * Math.SQRT2;
  for (let i = 0, k = 0; i < 4; ++i) if (i !== largest) into[k++] = Math.floor(sign * q[(i + 3) & 3] * scale + 0.5);
}
