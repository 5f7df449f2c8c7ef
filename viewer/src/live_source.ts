import type { Contact } from "./contacts";
import { makeMotion, type Motion } from "./frames";
import type { Header } from "./header";
import { numbersOfBody, type LiveFrame } from "./live_message";
import type { Mesh, MotionEvent, Run } from "./run";
import { RecordedSource, type FrameSource } from "./source";

/** Rows of the series that are kept for plots. */
const mostRows = 2000;

/** The newest frame of a live simulation; until one comes, the moment that the page holds. */
export class LiveSource implements FrameSource {
  readonly kind = "live";
  readonly header: Header;
  readonly meshes: Mesh[];
  readonly events: MotionEvent[] = [];
  readonly moving: number[];
  readonly frames = undefined;
  times: Float64Array;
  series = new Map<string, Float64Array>();
  onFrame?: () => void;
  private readonly newest: Motion;
  private contacts: Contact[];
  private rows: Float64Array[] = [];

  constructor(run: Run) {
    this.header = run.header;
    this.meshes = run.meshes;
    this.moving = run.frames.moving;
    this.newest = makeMotion(run.header.bodies.length);
    const first = new RecordedSource(run);
    first.sample(run.times[0], this.newest);
    this.contacts = first.contactsAt(run.times[0]);
    this.times = run.times.slice(0, 1);
  }

  /** Newest time [s]. */
  get time(): number {
    return this.times[0];
  }

  take(frame: LiveFrame): void {
    const { position, orientation, velocity, spin } = this.newest;
    this.moving.forEach((body, i) => {
      const own = frame.bodies.subarray(numbersOfBody * i, numbersOfBody * (i + 1));
      position.set(own.subarray(0, 3), 3 * body);
      orientation.set(own.subarray(3, 7), 4 * body);
      velocity.set(own.subarray(7, 10), 3 * body);
      spin.set(own.subarray(10, 13), 3 * body);
    });
    this.contacts = frame.contacts;
    this.times = Float64Array.of(frame.time);
    this.addRow(frame.series);
    this.onFrame?.();
  }

  sample(_time: number, into: Motion): void {
    into.position.set(this.newest.position);
    into.orientation.set(this.newest.orientation);
    into.velocity.set(this.newest.velocity);
    into.spin.set(this.newest.spin);
  }

  contactsAt(): Contact[] {
    return this.contacts;
  }

  /** Series of the last output times; after a reset they begin anew. */
  private addRow(row: Float64Array): void {
    const last = this.rows[this.rows.length - 1];
    if (last && row[0] < last[0]) this.rows = [];
    else if (last && row[0] === last[0]) return;
    this.rows.push(row);
    if (this.rows.length > mostRows) this.rows.splice(0, mostRows / 10);
    this.header.series.forEach(({ name }, i) => this.series.set(name, Float64Array.from(this.rows, (values) => values[i])));
  }
}
