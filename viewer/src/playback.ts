import { lastAtMost } from "./search";

/** Speeds to choose from, simulated seconds a second. */
export const speeds = [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10];

/** Where the replay stands. Time goes with the clock, whatever the drawing takes: slow drawing skips, it never slows. */
export class Playback {
  time: number;
  isPlaying = false;
  isLooping = true;
  speed = 1;

  constructor(readonly begin: number, readonly end: number) {
    this.time = begin;
  }

  /** Lets this much of the clock pass [s]. Returns whether anything changed. */
  advance(elapsed: number): boolean {
    if (!this.isPlaying || this.end <= this.begin) return false;
    const time = this.time + elapsed * this.speed;
    if (time < this.end) {
      this.time = time;
    } else if (this.isLooping) {
      this.time = this.begin + ((time - this.begin) % (this.end - this.begin));
    } else {
      this.time = this.end;
      this.isPlaying = false;
    }
    return true;
  }

  seek(time: number): void {
    this.time = Math.min(Math.max(time, this.begin), this.end);
  }

  /** Starts or stops; at the end it starts from the beginning. */
  toggle(): void {
    this.isPlaying = !this.isPlaying;
    if (this.isPlaying && this.time >= this.end) this.time = this.begin;
  }

  /** The next faster (1) or slower (-1) speed. */
  changeSpeed(direction: 1 | -1): void {
    const i = speeds.indexOf(this.speed) + direction;
    this.speed = speeds[Math.min(Math.max(i, 0), speeds.length - 1)];
  }
}

/** The frame time that is `frames` frames away from here; from between two frames a step goes to the nearer side's frame. */
export function steppedTime(times: ArrayLike<number>, time: number, frames: number): number {
  const i = lastAtMost(times, time);
  const isBetween = times[i] < time;
  const target = i + frames + (isBetween && frames < 0 ? 1 : 0);
  return times[Math.min(Math.max(target, 0), times.length - 1)];
}
