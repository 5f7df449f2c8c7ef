import { Reader } from "./reader";

export type ContactMode = "open" | "stick" | "slide" | "unknown";
const modes: ContactMode[] = ["open", "stick", "slide", "unknown"];

/** One point where two bodies touch. The normal points from A to B; the force is on B, zero if not known. */
export interface Contact {
  bodyA: number;
  bodyB: number;
  mode: ContactMode;
  /** [m], negative when overlapping. */
  gap: number;
  /** From Header.origin [m]. */
  point: [number, number, number];
  normal: [number, number, number];
  force: [number, number, number];
}

/** The contacts of all frames; a chunk is unpacked when one of its frames is asked for. */
export class Contacts {
  private readonly chunks: { first: number; bytes: Uint8Array }[] = [];
  private unpacked: { chunk: number; contacts: ContactChunk } | undefined;
  private latest: { frame: number; contacts: Contact[] } | undefined;
  private count = 0;
  /** In one frame. */
  most = 0;

  addChunk(bytes: Uint8Array): void {
    const reader = new Reader(bytes);
    for (let k = 0; k < 4; ++k) reader.f64();
    const frames = reader.u32();
    for (let k = 0; k < frames; ++k) this.most = Math.max(this.most, reader.varint());
    this.chunks.push({ first: this.count, bytes });
    this.count += frames;
  }

  at(frame: number): Contact[] {
    let chunk = this.chunks.length - 1;
    while (chunk > 0 && this.chunks[chunk].first > frame) --chunk;
    if (chunk < 0) return [];
    if (this.latest?.frame === frame) return this.latest.contacts;
    if (this.unpacked?.chunk !== chunk) this.unpacked = { chunk, contacts: new ContactChunk(this.chunks[chunk].bytes) };
    const own = frame - this.chunks[chunk].first;
    const contacts = own < this.unpacked.contacts.frames ? this.unpacked.contacts.at(own) : [];
    this.latest = { frame, contacts };
    return contacts;
  }
}

const numbersOfContact = 11;
/** Point and normal: expected to go on in a straight line. */
const firstSmooth = 2, endSmooth = 8;

/** A chunk (rigor/view/page/page_contacts.hpp): all numbers at once in flat arrays, the contacts of a frame when they are asked for. */
export class ContactChunk {
  private readonly steps: { force: number; gap: number; place: number; normal: number };
  /** Where each frame begins, and the end of the last. */
  private readonly starts: number[] = [0];
  private readonly bodyA: Int32Array;
  private readonly bodyB: Int32Array;
  /** Eleven numbers a contact. */
  private readonly numbers: Float64Array;

  constructor(bytes: Uint8Array) {
    const reader = new Reader(bytes);
    this.steps = { force: reader.f64(), gap: reader.f64(), place: reader.f64(), normal: reader.f64() };
    const frames = reader.u32();
    for (let k = 0; k < frames; ++k) this.starts.push(this.starts[k] + reader.varint());
    const total = this.starts[frames];
    this.bodyA = new Int32Array(total);
    this.bodyB = new Int32Array(total);
    this.numbers = new Float64Array(numbersOfContact * total);
    for (let i = 0; i < total; ++i) this.bodyA[i] = reader.varint();
    for (let i = 0; i < total; ++i) this.bodyB[i] = reader.varint();
    for (let k = 0; k < numbersOfContact; ++k) for (let i = 0; i < total; ++i) this.numbers[numbersOfContact * i + k] = reader.varint();
    this.unfold(frames);
  }

  get frames(): number {
    return this.starts.length - 1;
  }

  at(frame: number): Contact[] {
    const begin = this.starts[frame], count = this.starts[frame + 1] - begin;
    return Array.from({ length: count }, (_, i) => this.contact(begin + i));
  }

  /** Adds to the stored differences what they are differences from: the same contact of the last frame, and of the one before. */
  private unfold(frames: number): void {
    let last = new Places(), before = new Places();
    const { numbers } = this;
    for (let frame = 0; frame < frames; ++frame) {
      const now = new Places();
      let a = 0, b = -1, which = 0;
      for (let i = this.starts[frame]; i < this.starts[frame + 1]; ++i) {
        const ownA = (this.bodyA[i] += a), ownB = (this.bodyB[i] += ownA);
        which = ownA === a && ownB === b ? which + 1 : 0;
        [a, b] = [ownA, ownB];
        // Exact up to two million bodies; no frame has more than 2048 points a pair.
        const name = (a * 2097152 + b) * 2048 + which;
        const newer = last.of(name), older = newer < 0 ? -1 : before.of(name);
        const at = numbersOfContact * i;
        if (newer >= 0) for (let k = 0; k < numbersOfContact; ++k) numbers[at + k] += numbers[numbersOfContact * newer + k];
        if (older >= 0) for (let k = firstSmooth; k < endSmooth; ++k) numbers[at + k] += numbers[numbersOfContact * newer + k] - numbers[numbersOfContact * older + k];
        now.add(name, i);
      }
      [before, last] = [last, now];
    }
  }

  private contact(i: number): Contact {
    const { numbers, steps } = this;
    const at = numbersOfContact * i;
    const vector = (from: number, step: number): [number, number, number] => [numbers[at + from] * step, numbers[at + from + 1] * step, numbers[at + from + 2] * step];
    return {
      bodyA: this.bodyA[i],
      bodyB: this.bodyB[i],
      mode: modes[numbers[at]] ?? "unknown",
      gap: numbers[at + 1] * steps.gap,
      point: vector(2, steps.place),
      normal: vector(5, steps.normal),
      force: vector(8, steps.force),
    };
  }
}

/** Where the contacts of a frame are, by their names. Most frames have them in ascending order and are asked in that order: a look ahead finds them. */
class Places {
  private readonly names: number[] = [];
  private readonly places: number[] = [];
  private isAscending = true;
  private next = 0;
  private byName: Map<number, number> | undefined;

  add(name: number, place: number): void {
    if (this.names.length > 0 && name < this.names[this.names.length - 1]) this.isAscending = false;
    this.names.push(name);
    this.places.push(place);
  }

  /** -1 if there is none; of several the last. */
  of(name: number): number {
    const { names, places } = this;
    if (!this.isAscending) {
      this.byName ??= new Map(names.map((own, i) => [own, places[i]]));
      return this.byName.get(name) ?? -1;
    }
    // Who asks begins anew where it asks for less than before.
    if (this.next > 0 && names[this.next - 1] >= name) this.next = 0;
    while (this.next < names.length && names[this.next] < name) ++this.next;
    return names[this.next] === name ? places[this.next] : -1;
  }
}
