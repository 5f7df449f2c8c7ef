import type { MotionTable } from "./frames";
import { numbersOfBody } from "./live_message";

/** Numbers that are kept for all bodies and times together. */
const mostNumbers = 4_000_000;
const mostRows = 1024, fewestRows = 16;

/**
 * The motion that a live page has seen since the last reset. When there are too many rows every second one goes, and those that
 * come later are kept as far apart; the newest is always the last.
 */
export class LiveFrames implements MotionTable {
  readonly position: Float32Array;
  readonly velocity: Float32Array;
  readonly spin: Float32Array;
  private readonly turns: Float32Array;
  private readonly rowTimes: Float64Array;
  private count = 0;
  /** Least time between two rows [s]. */
  private spacing = 0;

  constructor(readonly moving: number[]) {
    const n = moving.length;
    const rows = Math.min(mostRows, Math.max(fewestRows, Math.floor(mostNumbers / (numbersOfBody * Math.max(1, n)))));
    this.rowTimes = new Float64Array(rows);
    this.position = new Float32Array(3 * n * rows);
    this.velocity = new Float32Array(3 * n * rows);
    this.spin = new Float32Array(3 * n * rows);
    this.turns = new Float32Array(4 * n * rows);
  }

  get times(): Float64Array {
    return this.rowTimes.subarray(0, this.count);
  }

  /** A moment; an earlier one than the last begins anew. bodies: as in LiveFrame. */
  add(time: number, bodies: Float32Array): void {
    if (this.count > 0 && time < this.rowTimes[this.count - 1]) {
      this.count = 0;
      this.spacing = 0;
    }
    const last = this.count - 1;
    const isClose = last >= 0 && (time === this.rowTimes[last] || (last >= 1 && this.rowTimes[last] - this.rowTimes[last - 1] < this.spacing));
    if (!isClose && this.count === this.rowTimes.length) this.halve();
    if (!isClose) ++this.count;
    this.set(this.count - 1, time, bodies);
  }

  orientation(row: number, i: number, into: Float32Array, at: number): void {
    const from = 4 * (row * this.moving.length + i);
    for (let c = 0; c < 4; ++c) into[at + c] = this.turns[from + c];
  }

  private set(row: number, time: number, bodies: Float32Array): void {
    this.rowTimes[row] = time;
    for (let i = 0; i < this.moving.length; ++i) {
      const place = row * this.moving.length + i;
      const own = bodies.subarray(numbersOfBody * i, numbersOfBody * (i + 1));
      this.position.set(own.subarray(0, 3), 3 * place);
      this.turns.set(own.subarray(3, 7), 4 * place);
      this.velocity.set(own.subarray(7, 10), 3 * place);
      this.spin.set(own.subarray(10, 13), 3 * place);
    }
  }

  private halve(): void {
    const n = this.moving.length;
    const span = this.rowTimes[this.count - 1] - this.rowTimes[0];
    this.count = Math.ceil(this.count / 2);
    for (let row = 1; row < this.count; ++row) {
      this.rowTimes[row] = this.rowTimes[2 * row];
      for (const table of [this.position, this.velocity, this.spin]) table.copyWithin(3 * n * row, 6 * n * row, 6 * n * row + 3 * n);
      this.turns.copyWithin(4 * n * row, 8 * n * row, 8 * n * row + 4 * n);
    }
    this.spacing = span / this.count;
  }
}
