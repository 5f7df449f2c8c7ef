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

  constructor(private readonly header: Header) {
    this.moving = header.bodies.flatMap((body, i) => (body.motion === "static" ? [] : [i]));
    const size = this.moving.length * header.frames;
    this.position = new Float32Array(3 * size);
    this.velocity = new Float32Array(3 * size);
    this.spin = new Float32Array(3 * size);
    this.components = new Int16Array(3 * size);
    this.largest = new Uint8Array(size);
  }

  /** Appends a chunk (rigor/view/page/page_frames.hpp). */
  addChunk(bytes: Uint8Array): void {
    const reader = new Reader(bytes);
    const speedStep = reader.f64();
    const spinStep = reader.f64();
    const frames = reader.u32();
    const bodies = reader.u32();
    const n = this.moving.length;
    if (bodies !== n || this.count + frames > this.header.frames) {
      throw new DataError("a frames block does not belong to this run");
    }
    for (let body = 0; body < n; ++body) {
      const place = this.count * n + body;
      const vectors = (into: Float32Array | Int16Array, scale: number) => {
        for (let k = 0; k < 3; ++k) reader.column(frames, scale, into, 3 * place + k, 3 * n);
      };
      vectors(this.position, this.header.position_step);
      reader.column(frames, 1, this.largest, place, n);
      vectors(this.components, 1);
      vectors(this.velocity, speedStep);
      vectors(this.spin, spinStep);
    }
    this.count += frames;
  }

  /** Orientation x y z w of the i-th moving body in a frame. */
  orientation(frame: number, i: number, into: Float32Array, at: number): void {
    const place = frame * this.moving.length + i;
    unpackQuaternion(this.largest[place], this.components, 3 * place, into, at, this.header.orientation_parts);
  }
}

/** The unit quaternion x y z w of its three smaller components, each in ±parts for ±1/√2; `largest` is in w x y z. */
export function unpackQuaternion(largest: number, others: ArrayLike<number>, from: number, into: Float32Array, at: number, parts = 32767): void {
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
