import { DataError } from "./blocks";
import type { Frames } from "./frames";
import type { Header } from "./header";
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

  constructor(private readonly header: Header, private readonly frames: Frames) {}

  addChunk(bytes: Uint8Array): void {
    const list = new ContactList(new Reader(bytes));
    for (let k = 0; k < list.frames; ++k) this.most = Math.max(this.most, list.starts[k + 1] - list.starts[k]);
    this.chunks.push({ first: this.count, bytes });
    this.count += list.frames;
  }

  at(frame: number): Contact[] {
    let chunk = this.chunks.length - 1;
    while (chunk > 0 && this.chunks[chunk].first > frame) --chunk;
    if (chunk < 0) return [];
    if (this.latest?.frame === frame) return this.latest.contacts;
    if (this.unpacked?.chunk !== chunk) this.unpacked = { chunk, contacts: new ContactChunk(this.chunks[chunk], this.header, this.frames) };
    const own = frame - this.chunks[chunk].first;
    const contacts = own < this.unpacked.contacts.frames ? this.unpacked.contacts.at(own) : [];
    this.latest = { frame, contacts };
    return contacts;
  }
}

const numbersOfContact = 11;
/** Point and normal: expected to go on in a straight line. */
const firstSmooth = 2, endSmooth = 8;

/** Which contacts there are in the frames of a chunk, packed_contacts (rigor/view/page/page_contacts.hpp). */
class ContactList {
  readonly steps: { force: number; gap: number; place: number; normal: number };
  /** Whether points and normals are expected to go on in a straight line. */
  readonly isSmooth: boolean;
  /** Where each frame begins, and the end of the last. */
  readonly starts: number[] = [0];
  readonly bodyA: number[] = [];
  readonly bodyB: number[] = [];
  /** The place of the same contact in the frame before; -1: it is new. */
  readonly from: number[] = [];

  constructor(reader: Reader) {
    this.steps = { force: reader.f64(), gap: reader.f64(), place: reader.f64(), normal: reader.f64() };
    this.isSmooth = reader.u32() > 1;
    const frames = reader.u32();
    const added = Array.from({ length: frames }, () => reader.varint());
    const kept = this.readKept(reader, added);
    const firstBodies = added.map((count) => {
      let body = 0;
      return Array.from({ length: count }, () => (body += reader.varint()));
    });
    const newPairs = firstBodies.map((firsts) => firsts.map((body): [number, number] => [body, body + reader.varint()]));
    for (let frame = 0; frame < frames; ++frame) this.merge(kept[frame], newPairs[frame]);
    reader.checkEnd();
  }

  get frames(): number {
    return this.starts.length - 1;
  }

  /** For each frame the places, among those of the frame before, of the contacts that stay. */
  private readKept(reader: Reader, added: number[]): number[][] {
    let count = 0;
    return added.map((own) => {
      const kept: number[] = [];
      for (let at = 0, stays = true; at < count; stays = !stays) {
        const end = at + reader.varint();
        if (end < at || end > count) throw new DataError("a contacts block does not fit itself");
        for (; at < end; ++at) if (stays) kept.push(at);
      }
      count = kept.length + own;
      return kept;
    });
  }

  /** Adds a frame: what stays and what is new in the order of bodies, of one pair what stays before what is new. */
  private merge(kept: number[], added: [number, number][]): void {
    const last = this.starts.length > 1 ? this.starts[this.starts.length - 2] : 0;
    let i = 0;
    const keep = () => {
      const from = last + kept[i++];
      this.push(this.bodyA[from], this.bodyB[from], from);
    };
    for (const [a, b] of added) {
      const comesFirst = (from: number) => this.bodyA[from] < a || (this.bodyA[from] === a && this.bodyB[from] <= b);
      while (i < kept.length && comesFirst(last + kept[i])) keep();
      this.push(a, b, -1);
    }
    while (i < kept.length) keep();
    this.starts.push(this.bodyA.length);
  }

  private push(a: number, b: number, from: number): void {
    this.bodyA.push(a);
    this.bodyB.push(b);
    this.from.push(from);
  }
}

/** All numbers of a chunk at once in a flat array, the contacts of a frame when they are asked for. */
class ContactChunk {
  private readonly list: ContactList;
  /** Eleven numbers a contact. */
  private readonly numbers: Float64Array;

  constructor(private readonly chunk: { first: number; bytes: Uint8Array }, private readonly header: Header, private readonly motion: Frames) {
    const reader = new Reader(chunk.bytes);
    this.list = new ContactList(reader);
    const total = this.list.from.length;
    this.numbers = new Float64Array(numbersOfContact * total);
    for (let k = 0; k < numbersOfContact; ++k) for (let i = 0; i < total; ++i) this.numbers[numbersOfContact * i + k] = reader.varint();
    reader.checkEnd();
    this.unfold();
  }

  get frames(): number {
    return this.list.frames;
  }

  at(frame: number): Contact[] {
    const { starts } = this.list;
    return Array.from({ length: starts[frame + 1] - starts[frame] }, (_, i) => this.contact(starts[frame] + i, this.chunk.first + frame));
  }

  /** Adds to the stored differences what they are differences from: the same contact of the last frame, and of the one before. */
  private unfold(): void {
    const { numbers } = this;
    const { from, isSmooth } = this.list;
    for (let i = 0; i < from.length; ++i) {
      if (from[i] < 0) continue;
      const at = numbersOfContact * i, newer = numbersOfContact * from[i];
      for (let k = 0; k < numbersOfContact; ++k) numbers[at + k] += numbers[newer + k];
      if (!isSmooth || from[from[i]] < 0) continue;
      const older = numbersOfContact * from[from[i]];
      for (let k = firstSmooth; k < endSmooth; ++k) numbers[at + k] += numbers[newer + k] - numbers[older + k];
    }
  }

  private contact(i: number, frame: number): Contact {
    const { numbers } = this;
    const { steps, bodyA, bodyB, isSmooth } = this.list;
    const at = numbersOfContact * i;
    const middle = this.middle(bodyA[i], bodyB[i], frame);
    const direction = isSmooth ? origin : this.direction(bodyA[i], bodyB[i], frame);
    const vector = (first: number, step: number, from: number[]) => from.map((x, c) => (x + numbers[at + first + c]) * step) as [number, number, number];
    return {
      bodyA: bodyA[i],
      bodyB: bodyB[i],
      mode: modes[numbers[at]] ?? "unknown",
      gap: numbers[at + 1] * steps.gap,
      point: vector(2, steps.place, middle),
      normal: vector(5, steps.normal, direction),
      force: vector(8, steps.force, origin),
    };
  }

  /** The middle of the centres of mass of the bodies that are not static, in steps of places. */
  private middle(a: number, b: number, frame: number): number[] {
    const moving = [a, b].map((body) => this.motion.place(frame, body)).filter((place) => place >= 0);
    if (moving.length === 0) return origin;
    const ratio = (moving.length * this.list.steps.place) / this.header.position_step;
    return [0, 1, 2].map((c) => Math.floor(moving.reduce((sum, place) => sum + this.whole(place + c), 0) / ratio + 0.5));
  }

  /** The direction from the centre of a to that of b, in steps of normals; none if one of them is static. */
  private direction(a: number, b: number, frame: number): number[] {
    const [from, to] = [a, b].map((body) => this.motion.place(frame, body));
    if (from < 0 || to < 0) return origin;
    const d = [0, 1, 2].map((c) => this.whole(to + c) - this.whole(from + c));
    const square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    if (square === 0) return origin;
    const scale = Math.sqrt(square) * this.list.steps.normal;
    return d.map((x) => Math.floor(x / scale + 0.5));
  }

  /** A coordinate of a body in steps of positions. */
  private whole(place: number): number {
    return Math.round(this.motion.position[place] / this.header.position_step);
  }
}

const origin = [0, 0, 0];
