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
  /** In one frame. */
  most = 0;

  addChunk(bytes: Uint8Array): void {
    const reader = new Reader(bytes);
    for (let k = 0; k < 3; ++k) reader.f64();
    const frames = reader.u32();
    for (let k = 0; k < frames; ++k) this.most = Math.max(this.most, reader.varint());
    this.chunks.push({ first: this.count, bytes });
    this.count += frames;
  }

  at(frame: number): Contact[] {
    let chunk = this.chunks.length - 1;
    while (chunk > 0 && this.chunks[chunk].first > frame) --chunk;
    if (chunk < 0) return [];
    if (this.unpacked?.chunk !== chunk) {
      this.unpacked = { chunk, frames: unpackContacts(this.chunks[chunk].bytes) };
    }
    return this.unpacked.frames[frame - this.chunks[chunk].first] ?? [];
  }
}

const numbersOfContact = 11;
/** Point and normal: expected to go on in a straight line. */
const isSmooth = (k: number): boolean => k >= 2 && k < 8;

/** The frames of a chunk (rigor/view/page/page_contacts.hpp). */
export function unpackContacts(bytes: Uint8Array): Contact[][] {
  const reader = new Reader(bytes);
  const forceStep = reader.f64(), gapStep = reader.f64(), placeStep = reader.f64();
  const column = (count: number) => Array.from({ length: count }, () => reader.varint());
  const counts = column(reader.u32());
  const total = counts.reduce((sum, count) => sum + count, 0);
  const stepsA = column(total), stepsB = column(total);
  const numbers = Array.from({ length: numbersOfContact }, () => column(total));
  let before = new Map<string, number[]>(), last = new Map<string, number[]>();
  let at = 0;
  return counts.map((count) => {
    const now = new Map<string, number[]>();
    let bodyA = 0, bodyB = -1, which = 0;
    const contacts = Array.from({ length: count }, () => {
      const a = bodyA + stepsA[at];
      const b = a + stepsB[at];
      which = a === bodyA && b === bodyB ? which + 1 : 0;
      [bodyA, bodyB] = [a, b];
      const name = `${a} ${b} ${which}`;
      const newer = last.get(name), older = before.get(name);
      const own = numbers.map((values, k) => values[at] + (newer ? newer[k] + (older && isSmooth(k) ? newer[k] - older[k] : 0) : 0));
      now.set(name, own);
      ++at;
      return contactOf(a, b, own, placeStep, gapStep, forceStep);
    });
    [before, last] = [last, now];
    return contacts;
  });
}

function contactOf(bodyA: number, bodyB: number, numbers: number[], placeStep: number, gapStep: number, forceStep: number): Contact {
  const vector = (from: number, step: number): [number, number, number] =>
    [numbers[from] * step, numbers[from + 1] * step, numbers[from + 2] * step];
  return {
    bodyA,
    bodyB,
    mode: modes[numbers[0]] ?? "unknown",
    gap: numbers[1] * gapStep,
    point: vector(2, placeStep),
    normal: vector(5, 1 / 1024),
    force: vector(8, forceStep),
  };
}
