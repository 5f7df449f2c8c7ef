import { DataError, readBlock, type BlockText } from "./blocks";
import { Contacts } from "./contacts";
import { Frames } from "./frames";
import type { Header, Vec } from "./header";
import type { Precision } from "./precision";
import { Reader } from "./reader";

export type EventKind = "impact" | "rest" | "separation" | "slip_to_stick";
export const eventKinds: EventKind[] = ["impact", "rest", "separation", "slip_to_stick"];

export interface MotionEvent {
  kind: EventKind;
  /** [s]. */
  time: number;
  bodyA: number;
  bodyB: number;
  /** World [m]. */
  point: Vec;
  /** On B [N s]. */
  impulse: Vec;
}

export interface Mesh {
  vertices: Float32Array;
  triangles: Uint32Array;
}

/** One run as its page stores it. */
export interface Run {
  header: Header;
  meshes: Mesh[];
  /** One array a quantity of Header.series, as far as frames were read. */
  series: Map<string, Float64Array>;
  times: Float64Array;
  /** In the order of their times. */
  events: MotionEvent[];
  frames: Frames;
  contacts: Contacts;
}

export interface Loaded {
  runs: Run[];
  /** Of a comparison whose errors are known. */
  precision?: Precision;
  /** What is not as it should be, for the reader; the runs hold what could be read. */
  problems: string[];
}

/** Reads the runs of a page. Without a whole header, mesh, series and frame there is nothing to show: DataError. */
export async function loadRuns(blocks: BlockText[], expected: number, progress: (part: number) => void): Promise<Loaded> {
  if (blocks.length === 0) throw new DataError("this page holds no data blocks");
  const problems: string[] = [];
  if (blocks.length < expected) {
    problems.push(`the page is cut: ${blocks.length} of ${expected} data blocks are there`);
  }
  const runs: Run[] = [];
  const numbers = [...new Set(blocks.map((block) => block.run))];
  for (const number of numbers) {
    const own = blocks.filter((block) => block.run === number);
    const ownProblems: string[] = [];
    try {
      runs.push(await loadRun(own, ownProblems, (part) => progress((runs.length + part) / numbers.length)));
    } catch (error) {
      if (!(error instanceof DataError)) throw error;
      ownProblems.push(error.message);
    }
    problems.push(...ownProblems.map((problem) => (numbers.length > 1 ? `run ${number + 1}: ${problem}` : problem)));
  }
  // One run of several may be missing.
  if (runs.length === 0) throw new DataError(problems.join("; "));
  return { runs, precision: await readPrecision(blocks, problems), problems };
}

/** What the page tells of work and precision; nothing if it does not, or if that did not arrive whole. */
async function readPrecision(blocks: BlockText[], problems: string[]): Promise<Precision | undefined> {
  const block = blocks.find(({ kind }) => kind === "precision");
  if (!block) return undefined;
  try {
    return JSON.parse(new TextDecoder().decode(await readBlock(block))) as Precision;
  } catch (error) {
    if (!(error instanceof DataError)) throw error;
    problems.push(`${error.message}; the plots of work and precision are left out`);
    return undefined;
  }
}

async function loadRun(blocks: BlockText[], problems: string[], progress: (part: number) => void): Promise<Run> {
  const only = async (kind: string): Promise<Uint8Array> => {
    const block = blocks.find((candidate) => candidate.kind === kind);
    if (!block) throw new DataError(`the ${kind} block is missing`);
    return readBlock(block);
  };
  const header = parseHeader(await only("header"));
  const frames = new Frames(header);
  const run: Run = {
    header,
    meshes: readMeshes(await only("meshes"), header),
    series: new Map(),
    times: new Float64Array(),
    events: [],
    frames,
    contacts: new Contacts(header, frames),
  };
  const series = new Reader(await only("series"));
  run.events = await readEvents(header, problems, only);
  await readChunks(blocks, run, problems, progress);
  if (run.frames.count === 0) throw new DataError([...problems.splice(0), "no frame could be read"].join("; "));
  for (const { name } of header.series) run.series.set(name, series.exactColumn(header.frames).slice(0, run.frames.count));
  run.times = run.series.get("time") ?? new Float64Array();
  return run;
}

function parseHeader(bytes: Uint8Array): Header {
  const header = JSON.parse(new TextDecoder().decode(bytes)) as Header;
  if (header.format !== 2) throw new DataError(`the data have format ${header.format}; this viewer knows format 2`);
  return header;
}

async function readEvents(header: Header, problems: string[], only: (kind: string) => Promise<Uint8Array>): Promise<MotionEvent[]> {
  try {
    return unpackEvents(new Reader(await only("events")), header);
  } catch (error) {
    if (!(error instanceof DataError)) throw error;
    problems.push(`${error.message}; no events are shown`);
    return [];
  }
}

/** Frames and contacts up to the first chunk that did not arrive whole. */
async function readChunks(blocks: BlockText[], run: Run, problems: string[], progress: (part: number) => void): Promise<void> {
  const chunks = blocks.filter((block) => block.kind === "frames" || block.kind === "contacts");
  try {
    for (let i = 0; i < chunks.length; ++i) {
      const bytes = await readBlock(chunks[i]);
      if (chunks[i].kind === "frames") run.frames.addChunk(bytes);
      else run.contacts.addChunk(bytes);
      progress((i + 1) / chunks.length);
    }
  } catch (error) {
    if (!(error instanceof DataError)) throw error;
    problems.push(error.message);
  }
  if (run.frames.count < run.header.frames) {
    problems.push(`the first ${run.frames.count} of ${run.header.frames} frames are shown`);
  }
}

function readMeshes(bytes: Uint8Array, header: Header): Mesh[] {
  const reader = new Reader(bytes);
  return header.meshes.map((mesh) => ({
    vertices: Float32Array.from({ length: 3 * mesh.vertices }, () => reader.f32()),
    triangles: Uint32Array.from({ length: 3 * mesh.triangles }, () => reader.u32()),
  }));
}

/** As PageRun::events_block (rigor/view/page/page_run.cpp) packs them. */
function unpackEvents(reader: Reader, header: Header): MotionEvent[] {
  const count = header.events;
  const timeStep = reader.f64();
  const impulseStep = reader.f64();
  const time = new Float64Array(count);
  reader.column(count, timeStep, time, 0, 1);
  const varints = (size: number) => Float64Array.from({ length: size }, () => reader.varint());
  const point = varints(3 * count);
  const impulse = varints(3 * count);
  const rest = varints(3 * count);
  const { origin, position_step } = header;
  const events = Array.from({ length: count }, (_, i): MotionEvent => ({
    kind: eventKinds[rest[3 * i + 2]] ?? "impact",
    time: time[i],
    bodyA: rest[3 * i],
    bodyB: rest[3 * i + 1],
    point: origin.map((x, c) => x + point[3 * i + c] * position_step) as Vec,
    impulse: [0, 1, 2].map((c) => impulse[3 * i + c] * impulseStep) as Vec,
  }));
  return events.sort((a, b) => a.time - b.time);
}
