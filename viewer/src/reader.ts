import { DataError } from "./blocks";

/** Reads numbers from bytes, one after the other, as rigor/view/page_block.hpp writes them. */
export class Reader {
  private at = 0;
  private readonly view: DataView;

  constructor(private readonly bytes: Uint8Array) {
    this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  }

  get left(): number {
    return this.bytes.length - this.at;
  }

  u32(): number {
    return this.view.getUint32(this.take(4), true);
  }
  f32(): number {
    return this.view.getFloat32(this.take(4), true);
  }
  f64(): number {
    return this.view.getFloat64(this.take(8), true);
  }
  f64s(count: number): Float64Array {
    return Float64Array.from({ length: count }, () => this.f64());
  }

  /** Groups of seven bits, the lowest first, with the sign folded in. Exact up to 2⁵². */
  varint(): number {
    const bytes = this.bytes;
    let byte = bytes[this.at++];
    if (byte < 128) return byte & 1 ? -(byte + 1) / 2 : byte / 2;
    let folded = byte & 127;
    let weight = 128;
    do {
      if (this.at >= bytes.length) throw new DataError("a block ends inside a number");
      byte = bytes[this.at++];
      folded += (byte & 127) * weight;
      weight *= 128;
    } while (byte >= 128);
    return folded % 2 ? -(folded + 1) / 2 : folded / 2;
  }

  /** A column of whole numbers, times the scale, into every stride-th place of the array. */
  column(count: number, scale: number, into: Float64Array | Float32Array | Int16Array | Uint8Array, start: number, stride: number): void {
    let last = 0;
    let before = 0;
    for (let k = 0, place = start; k < count; ++k, place += stride) {
      const value = this.varint() + (k < 2 ? last : 2 * last - before);
      into[place] = value * scale;
      before = last;
      last = value;
    }
    if (this.at > this.bytes.length) throw new DataError("a block ends before its last number");
  }

  private take(size: number): number {
    if (this.left < size) throw new DataError("a block ends before its last number");
    this.at += size;
    return this.at - size;
  }
}

