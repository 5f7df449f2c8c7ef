import { crc32 } from "./crc32";

/** A data block as it stands in the page, still text. */
export interface BlockText {
  run: number;
  kind: string;
  rawSize: number;
  size: number;
  crc: string;
  text: string;
}

/** Why data cannot be shown, in words for the reader of the page. */
export class DataError extends Error {}

/** The bytes of a block. Throws DataError when it did not arrive whole. */
export async function readBlock(block: BlockText): Promise<Uint8Array> {
  const packed = bytesOfText(block);
  if (packed.length !== block.size) {
    throw new DataError(`the ${block.kind} block is cut: ${packed.length} of ${block.size} bytes are there`);
  }
  if (crc32(packed).toString(16).padStart(8, "0") !== block.crc) {
    throw new DataError(`the ${block.kind} block is damaged: its checksum is not ${block.crc}`);
  }
  const bytes = await inflate(packed, block.kind);
  if (bytes.length !== block.rawSize) {
    throw new DataError(`the ${block.kind} block has ${bytes.length} bytes instead of ${block.rawSize}`);
  }
  return bytes;
}

/** The blocks of a document in their order. The last one of a page that was cut off may lack its end. */
export function findBlocks(root: ParentNode): BlockText[] {
  return [...root.querySelectorAll<HTMLScriptElement>("script.rigor-data")].map((element) => ({
    run: Number(element.dataset.run ?? 0),
    kind: element.dataset.kind ?? "unnamed",
    rawSize: Number(element.dataset.raw ?? -1),
    size: Number(element.dataset.size ?? -1),
    crc: element.dataset.crc ?? "",
    text: element.textContent ?? "",
  }));
}

/** ASCII characters that HTML changes and that therefore stand in no block. */
const leftOut = [0, 13, 60];

/** As seven_bit_text (rigor/view/page/page_block.hpp) writes them. */
function bytesOfText({ text, size, kind }: BlockText): Uint8Array {
  const bytes = new Uint8Array(Math.max(0, Math.min(size, (7 * 2 * text.length) >> 3)));
  let at = 0, bits = 0, count = 0;
  const take = (group: number) => {
    bits = ((bits << 7) | group) & 0x7fff;
    if ((count += 7) < 8) return;
    count -= 8;
    // After the last byte come bits that fill a group.
    if (at < bytes.length) bytes[at++] = bits >> count;
  };
  for (let i = 0; i < text.length; ++i) {
    const code = text.charCodeAt(i);
    if (code < 128) {
      take(code);
    } else if (code < 128 * (1 + leftOut.length)) {
      // One of those left out, and the group after it.
      take(leftOut[(code >> 7) - 1]);
      take(code & 127);
    } else if (i < text.length - 1) {
      // A text that was cut may end inside a character.
      throw new DataError(`the ${kind} block is damaged: it holds characters that are none of its own`);
    }
  }
  return bytes.subarray(0, at);
}

async function inflate(packed: Uint8Array, kind: string): Promise<Uint8Array> {
  if (typeof DecompressionStream === "undefined") {
    throw new DataError("this browser cannot decompress data (DecompressionStream); a newer one can");
  }
  try {
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  } catch {
    throw new DataError(`the ${kind} block is damaged: it cannot be decompressed`);
  }
}
