import { describe, expect, test } from "vitest";
import { DataError, readBlock } from "../src/blocks";
import { crc32 } from "../src/crc32";
import { blockOf } from "./bytes";

describe("blocks", () => {
  const bytes = Uint8Array.from({ length: 1000 }, (_, i) => (i * i) % 251);

  test("the checksum is CRC-32", () => {
    // The check value of the CRC catalogues.
    expect(crc32(new TextEncoder().encode("123456789"))).toBe(0xcbf43926);
  });

  test("a whole block gives its bytes", async () => {
    expect(await readBlock(blockOf("frames", bytes))).toEqual(bytes);
    expect(await readBlock(blockOf("meshes", new Uint8Array()))).toEqual(new Uint8Array());
  });

  test("every byte comes through, and none of the characters that HTML changes stands in the text", async () => {
    const all = Uint8Array.from({ length: 4096 }, (_, i) => (i * 37 + (i >> 8)) % 256);
    for (let length = 0; length < 20; ++length) {
      const block = blockOf("frames", all.subarray(0, length));
      expect(await readBlock(block)).toEqual(all.subarray(0, length));
    }
    const block = blockOf("frames", all);
    expect(block.text).not.toMatch(/[\0\r<]/);
    expect(await readBlock(block)).toEqual(all);
  });

  test("every cut is told as one", async () => {
    const block = blockOf("frames", bytes);
    for (let length = 0; length < block.text.length - 4; length += 7) {
      await expect(readBlock({ ...block, text: block.text.slice(0, length) })).rejects.toThrow(/the frames block is cut: \d+ of \d+ bytes/);
    }
  });

  test("every changed character is noticed", async () => {
    const block = blockOf("frames", bytes);
    for (let i = 0; i < block.text.length - 4; i += 5) {
      const other = block.text[i] === "A" ? "B" : "A";
      await expect(readBlock({ ...block, text: block.text.slice(0, i) + other + block.text.slice(i + 1) })).rejects.toThrow(/is (damaged|cut)/);
    }
    await expect(readBlock({ ...block, text: "\u4e2d" + block.text.slice(1) })).rejects.toThrow(/none of its own/);
  });

  test("a checksum that was damaged itself and a wrong size are told", async () => {
    const block = blockOf("series", bytes);
    await expect(readBlock({ ...block, crc: "00000000" })).rejects.toThrow(DataError);
    await expect(readBlock({ ...block, rawSize: 999 })).rejects.toThrow(/1000 bytes instead of 999/);
  });
});
