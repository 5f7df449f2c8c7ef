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
  const packed = decodeBase64(block);
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

function decodeBase64(block: BlockText): Uint8Array {
  try {
    // A cut text may end inside a group of four; whole groups are enough to count the bytes.
    const text = block.text.trim();
    const binary = atob(text.slice(0, text.length - (text.length % 4)));
    const bytes = new Uint8Array(binary.length);
    for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
    return bytes;
  } catch {
    throw new DataError(`the ${block.kind} block is damaged: it holds characters that are not base64`);
  }
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
