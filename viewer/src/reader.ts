import { DataError } from "./blocks";

export type Numbers = Float64Array | Float32Array | Int16Array | Uint8Array;

/** Reads numbers from bytes, one after the other, as rigor/view/page/page_block.hpp writes them. */
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

  /** A column of whole numbers, times the scale, into every stride-th place of the array; order: of ColumnOrder (rigor/view/page/page_block.hpp). */
  column(count: number, scale: number, into: Numbers, start: number, stride: number, order = 2): void {
    let last = 0, before = 0, earlier = 0;
    for (let k = 0, place = start; k < count; ++k, place += stride) {
      let value = this.varint() + last;
      if (k > 1 && order > 1) value += last - before;
      if (k > 2 && order > 2) value += last - 2 * before + earlier;
      into[place] = value * scale;
      earlier = before;
      before = last;
      last = value;
    }
    this.checkEnd();
  }

  /** Throws DataError if a number was read beyond the end. */
  checkEnd(): void {
    if (this.at > this.bytes.length) throw new DataError("a block ends before its last number");
  }

  /** Numbers to the last bit, as append_exact_column writes them. */
  exactColumn(count: number): Float64Array {
    const planes = Array.from({ length: 8 }, () => this.take(count));
    const values = new DataView(new ArrayBuffer(8 * count));
    let last = 0n;
    let before = 0n;
    for (let k = 0; k < count; ++k) {
      let folded = 0n;
      for (const plane of planes) folded = (folded << 8n) | BigInt(this.bytes[plane + k]);
      const step = folded & 1n ? -(folded >> 1n) - 1n : folded >> 1n;
      const bits = BigInt.asUintN(64, step + (k < 2 ? last : 2n * last - before));
      values.setBigUint64(8 * k, bits);
      before = last;
      last = bits;
    }
    return Float64Array.from({ length: count }, (_, k) => values.getFloat64(8 * k));
  }

  private take(size: number): number {
    if (this.left < size) throw new DataError("a block ends before its last number");
    this.at += size;
    return this.at - size;
  }
}

