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
  private unpacked: { chunk: number; frames: Contact[][] } | undefined;
  private count = 0;

  constructor(private readonly header: Header) {}

  addChunk(bytes: Uint8Array): void {
    const frames = new DataView(bytes.buffer, bytes.byteOffset).getUint32(16, true);
    this.chunks.push({ first: this.count, bytes });
    this.count += frames;
  }

  at(frame: number): Contact[] {
    let chunk = this.chunks.length - 1;
    while (chunk > 0 && this.chunks[chunk].first > frame) --chunk;
    if (chunk < 0) return [];
    if (this.unpacked?.chunk !== chunk) {
      this.unpacked = { chunk, frames: unpackContacts(this.chunks[chunk].bytes, this.header.position_step) };
    }
    return this.unpacked.frames[frame - this.chunks[chunk].first] ?? [];
  }
}

/** The frames of a chunk (rigor/view/page_contacts.hpp). */
export function unpackContacts(bytes: Uint8Array, positionStep: number): Contact[][] {
  const reader = new Reader(bytes);
  const forceStep = reader.f64();
  const gapStep = reader.f64();
  const frameCount = reader.u32();
  const frames: Contact[][] = [];
  let before = new Map<string, number[]>();
  for (let frame = 0; frame < frameCount; ++frame) {
    const now = new Map<string, number[]>();
    const contacts: Contact[] = [];
    const count = reader.varint();
    let bodyA = 0;
    let bodyB = -1;
    let which = 0;
    for (let i = 0; i < count; ++i) {
      const a = bodyA + reader.varint();
      const b = a + reader.varint();
      which = a === bodyA && b === bodyB ? which + 1 : 0;
      [bodyA, bodyB] = [a, b];
      const name = `${a} ${b} ${which}`;
      const earlier = before.get(name);
      const numbers = Array.from({ length: 11 }, (_, k) => reader.varint() + (earlier ? earlier[k] : 0));
      now.set(name, numbers);
      contacts.push(contactOf(a, b, numbers, positionStep, gapStep, forceStep));
    }
    before = now;
    frames.push(contacts);
  }
  return frames;
}

function contactOf(bodyA: number, bodyB: number, numbers: number[], positionStep: number, gapStep: number, forceStep: number): Contact {
  const vector = (from: number, step: number): [number, number, number] =>
    [numbers[from] * step, numbers[from + 1] * step, numbers[from + 2] * step];
  return {
    bodyA,
    bodyB,
    mode: modes[numbers[0]] ?? "unknown",
    gap: numbers[1] * gapStep,
    point: vector(2, positionStep),
    normal: vector(5, 1 / 1024),
    force: vector(8, forceStep),
  };
}
