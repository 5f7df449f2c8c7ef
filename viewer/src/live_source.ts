import type { Contact } from "./contacts";
import { makeMotion, type Motion } from "./frames";
import type { Header } from "./header";
import { LiveFrames } from "./live_frames";
import { numbersOfBody, type LiveFrame, type LiveHistory } from "./live_message";
import type { Mesh, MotionEvent, Run } from "./run";
import { RecordedSource, type FrameSource } from "./source";

/** The newest frame and the history of a live simulation; until they come, the moment that the page holds. */
export class LiveSource implements FrameSource {
  readonly kind = "live";
  readonly header: Header;
  readonly meshes: Mesh[];
  readonly moving: number[];
  readonly frames: LiveFrames;
  /** Newest time [s]. */
  time: number;
  times: Float64Array;
  series: Map<string, Float64Array>;
  events: MotionEvent[] = [];
  /** Events so far, also those that are not kept. */
  eventCount = 0;
  onFrame?: () => void;
  onHistory?: () => void;
  private readonly newest: Motion;
  private contacts: Contact[];
  mostContacts: number;

  constructor(run: Run) {
    this.header = run.header;
    this.meshes = run.meshes;
    this.moving = run.frames.moving;
    this.newest = makeMotion(run.header.bodies.length);
    const first = new RecordedSource(run);
    first.sample(run.times[0], this.newest);
    this.contacts = first.contactsAt(run.times[0]);
    this.mostContacts = this.contacts.length;
    this.time = run.times[0];
    this.times = run.times;
    this.series = run.series;
    this.frames = new LiveFrames(this.moving);
    this.frames.add(this.time, Float32Array.from(this.moving.flatMap((body) => this.numbersOf(body))));
  }

  get frameTimes(): Float64Array {
    return this.frames.times;
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
    this.mostContacts = Math.max(this.mostContacts, frame.contacts.length);
    this.time = frame.time;
    this.frames.add(frame.time, frame.bodies);
    this.onFrame?.();
  }

  remember({ columns, events, eventCount }: LiveHistory): void {
    this.series = new Map(this.header.series.map(({ name }, i) => [name, columns[i] ?? new Float64Array()]));
    this.times = this.series.get("time") ?? new Float64Array();
    this.events = events;
    this.eventCount = eventCount;
    this.onHistory?.();
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

  private numbersOf(body: number): number[] {
    const { position, orientation, velocity, spin } = this.newest;
    const three = (values: Float32Array) => [...values.subarray(3 * body, 3 * body + 3)];
    return [...three(position), ...orientation.subarray(4 * body, 4 * body + 4), ...three(velocity), ...three(spin)];
  }
}
