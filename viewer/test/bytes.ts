import { deflateSync } from "node:zlib";
import { crc32 } from "../src/crc32";
import type { BlockText } from "../src/blocks";
import type { Header } from "../src/header";

/** Writes numbers as rigor/view/page_block.hpp does. */
export class Writer {
  readonly bytes: number[] = [];
  f64(value: number): this {
    this.bytes.push(...new Uint8Array(new Float64Array([value]).buffer));
    return this;
  }
  u32(value: number): this {
    this.bytes.push(...new Uint8Array(new Uint32Array([value]).buffer));
    return this;
  }
  varint(value: number): this {
    let folded = value < 0 ? -2n * BigInt(value) - 1n : 2n * BigInt(value);
    for (; folded >= 128n; folded >>= 7n) this.bytes.push(Number(folded & 127n) | 128);
    this.bytes.push(Number(folded));
    return this;
  }
  column(values: number[]): this {
    values.forEach((value, k) => this.varint(value - (k === 0 ? 0 : k === 1 ? values[0] : 2 * values[k - 1] - values[k - 2])));
    return this;
  }
  get array(): Uint8Array {
    return Uint8Array.from(this.bytes);
  }
}

export function blockOf(kind: string, bytes: Uint8Array, run = 0): BlockText {
  const packed = deflateSync(bytes);
  return {
    run, kind, rawSize: bytes.length, size: packed.length, crc: crc32(packed).toString(16).padStart(8, "0"),
    text: packed.toString("base64"),
  };
}

/** One static floor and one ball that moves. */
export const header: Header = {
  format: 1, rigor: "0.1.0", scene: "test", duration: 1, step: 0.1, output_interval: 0.5, gravity: [0, 0, -10], origin: [10, 0, 0],
  extent: 2, position_step: 0.125, position_error: 0.0625, orientation_error: 1e-4, contact_tolerance: 1e-6, frames: 3, events: 1,
  series: [{ name: "time", unit: "s" }, { name: "kinetic", unit: "J" }],
  bodies: [
    { name: "floor", motion: "static", mass: 0, moments: [0, 0, 0], radius: null, frame: { p: [0, 0, 0], q: [1, 0, 0, 0] }, start: { p: [1, 2, 3], q: [0, 1, 0, 0] }, look: 0 },
    { name: "ball", motion: "dynamic", mass: 2, moments: [1, 1, 1], radius: 0.5, frame: { p: [0, 0, 0], q: [1, 0, 0, 0] }, start: { p: [10, 0, 0], q: [1, 0, 0, 0] }, look: 1 },
  ],
  looks: [[], []], meshes: [], materials: [], springs: [], joints: [], audit: {},
};

/** The ball at x = 8, 16, 24 steps and z = 8, 0, 8 steps from the origin, turned by nothing. */
export function framesChunk(): Uint8Array {
  const writer = new Writer().f64(0.5).f64(0.25).u32(3).u32(1);
  writer.column([8, 16, 24]).column([0, 0, 0]).column([8, 0, 8]);
  writer.column([0, 0, 0]).column([0, 0, 0]).column([0, 0, 0]).column([0, 0, 0]);
  writer.column([4, 4, 4]).column([0, 0, 0]).column([-4, -4, 4]);
  writer.column([1, 2, 3]).column([0, 0, 0]).column([0, 0, 0]);
  return writer.array;
}

export function pageBlocks(): BlockText[] {
  const series = new Writer();
  for (const value of [0, 0.5, 1, 7, 8, 9]) series.f64(value);
  const events = new Writer().f64(2 ** -20).f64(0.5).column([2 ** 19]);
  for (const value of [1, 2, 3, 0, 0, -6, 0, 1, 0]) events.varint(value);
  const contacts = new Writer().f64(2).f64(0.25).u32(3);
  for (let frame = 0; frame < 3; ++frame) {
    contacts.varint(1).varint(0).varint(1);
    // Mode, gap, point, normal, force; the same in every frame but for the force.
    const numbers = frame === 0 ? [1, -2, 8, 0, 4, 0, 0, 1024, 1, 0, 5] : [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, frame];
    numbers.forEach((value) => contacts.varint(value));
  }
  return [
    blockOf("header", new TextEncoder().encode(JSON.stringify(header))), blockOf("meshes", new Uint8Array()),
    blockOf("series", series.array), blockOf("events", events.array), blockOf("frames", framesChunk()), blockOf("contacts", contacts.array),
  ];
}
