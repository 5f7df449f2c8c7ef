import { deflateSync } from "node:zlib";
import { crc32 } from "../src/crc32";
import type { BlockText } from "../src/blocks";
import type { Header } from "../src/header";

/** Writes numbers as rigor/view/page/page_block.hpp does. */
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
  /** As residuals of a straight line through the last two. */
  column(values: number[]): this {
    values.forEach((value, k) => this.varint(value - (k === 0 ? 0 : k === 1 ? values[0] : 2 * values[k - 1] - values[k - 2])));
    return this;
  }
  exactColumn(values: number[]): this {
    const bits = [...new BigUint64Array(new Float64Array(values).buffer)];
    const folded = bits.map((value, k) => {
      const step = BigInt.asIntN(64, value - (k === 0 ? 0n : k === 1 ? bits[0] : 2n * bits[k - 1] - bits[k - 2]));
      return step < 0n ? -2n * step - 1n : 2n * step;
    });
    for (let shift = 56n; shift >= 0n; shift -= 8n) this.bytes.push(...folded.map((value) => Number((value >> shift) & 255n)));
    return this;
  }
  get array(): Uint8Array {
    return Uint8Array.from(this.bytes);
  }
}

/** Bytes as seven_bit_text (rigor/view/page/page_block.hpp) writes them. */
export function sevenBitText(bytes: Uint8Array): string {
  const bits = [...bytes].map((byte) => byte.toString(2).padStart(8, "0")).join("");
  const groups = (bits.match(/.{1,7}/g) ?? []).map((group) => parseInt(group.padEnd(7, "0"), 2));
  let text = "";
  while (groups.length > 0) {
    const group = groups.shift() ?? 0;
    const leftOut = [0, 13, 60].indexOf(group);
    text += String.fromCharCode(leftOut < 0 ? group : 128 + 128 * leftOut + (groups.shift() ?? 0));
  }
  return text;
}

export function blockOf(kind: string, bytes: Uint8Array, run = 0): BlockText {
  const packed = deflateSync(bytes);
  return {
    run, kind, rawSize: bytes.length, size: packed.length, crc: crc32(packed).toString(16).padStart(8, "0"),
    text: sevenBitText(packed),
  };
}

/** One static floor and one ball that moves. */
export const header: Header = {
  format: 2, rigor: "0.1.0", scene: "test", duration: 1, step: 0.1, output_interval: 0.5, gravity: [0, 0, -10], origin: [10, 0, 0],
  extent: 2, position_step: 0.125, position_error: 0.0625, orientation_error: 1e-4, orientation_parts: 32767, contact_tolerance: 1e-6, frames: 3, events: 1,
  series: [{ name: "time", unit: "s" }, { name: "kinetic", unit: "J" }],
  bodies: [
    { name: "floor", motion: "static", mass: 0, moments: [0, 0, 0], radius: null, frame: { p: [0, 0, 0], q: [1, 0, 0, 0] }, start: { p: [1, 2, 3], q: [0, 1, 0, 0] }, look: 0 },
    { name: "ball", motion: "dynamic", mass: 2, moments: [1, 1, 1], radius: 0.5, frame: { p: [0, 0, 0], q: [1, 0, 0, 0] }, start: { p: [10, 0, 0], q: [1, 0, 0, 0] }, look: 1 },
  ],
  looks: [[], []], meshes: [], materials: [], springs: [], joints: [], audit: {},
};

/**
 * The ball at x = 8, 16, 24 steps and z = 8, 0, 8 steps from the origin, turned by nothing. A step of the sum of two velocities in x
 * (4 + 4) is expected to make one of positions, and turns are not expected at all.
 */
export function framesChunk(): Uint8Array {
  const writer = new Writer().f64(0.5).f64(0.25).f64(65536).f64(0).u32(2).u32(1).u32(3).u32(1);
  const varints = (...values: number[]) => values.forEach((value) => writer.varint(value));
  writer.column([4, 4, 4]).column([0, 0, 0]).column([-4, -4, 4]);
  // Angular velocities by their differences: 1, 2, 3.
  varints(1, 1, 1, 0, 0, 0, 0, 0, 0);
  // Positions less what the velocities make of the last ones: x 8 + 8, 16 + 8, z 8 - 8, 0 + 0 and 8 more.
  varints(8, 0, 0, 0, 0, 0, 8, 0, 8);
  varints(0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0);
  return writer.array;
}

export function pageBlocks(): BlockText[] {
  const series = new Writer().exactColumn([0, 0.5, 1]).exactColumn([7, 8, 9]);
  const events = new Writer().f64(2 ** -20).f64(0.5).column([2 ** 19]);
  for (const value of [1, 2, 3, 0, 0, -6, 0, 1, 0]) events.varint(value);
  const contacts = new Writer().f64(2).f64(0.25).f64(0.125).f64(1 / 1024).u32(2).u32(3);
  // One contact, of the bodies 0 and 1, which stays from frame to frame; then mode, gap, point, normal, force: the force changes,
  // and the point, which goes 0, 1, 2 along x from the ball's centre: as expected from the third frame on.
  const columns = [[1, 0, 0], [1, 1], [0], [1], ...[1, -2, 0, 0, -4, 0, 0, 1024, 1, 0].map((value) => [value, 0, 0]), [5, 1, 2]];
  columns[6][1] = 1;
  columns.flat().forEach((value) => contacts.varint(value));
  return [
    blockOf("header", new TextEncoder().encode(JSON.stringify(header))), blockOf("meshes", new Uint8Array()),
    blockOf("series", series.array), blockOf("events", events.array), blockOf("frames", framesChunk()), blockOf("contacts", contacts.array),
  ];
}
