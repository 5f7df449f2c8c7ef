import * as format from "../format";

/** A number that each run has. */
export interface Column {
  name: string;
  isParameter: boolean;
  /** One a run; NaN where a run did not end, or where it is not finite. */
  values: Float64Array;
  low: number;
  high: number;
}

/** How a run of this page is replayed: by the server of the page, from files beside it, or by a command. */
export type Replay = { how: "served"; token: string } | { how: "kept"; folder: string } | { how: "command" };

/** The runs of a study that its page holds. */
export interface Study {
  name: string;
  file: string;
  /** Of the study; the page may hold fewer of them. */
  total: number;
  runs: number[];
  status: string[];
  reasons: Record<string, string>;
  columns: Column[];
  /** The column that the study is about. */
  main: number;
  replay: Replay;
}

interface Written {
  name: string;
  file: string;
  total: number;
  runs: number[];
  status: number[];
  statuses: string[];
  reasons: Record<string, string>;
  columns: { name: string; parameter: boolean; values: (number | null)[] }[];
  main: string;
  kept: string | null;
}

function columnOf({ name, parameter, values }: Written["columns"][number]): Column {
  const numbers = Float64Array.from(values, (value) => value ?? NaN);
  let low = Infinity, high = -Infinity;
  for (const value of numbers) {
    if (value < low) low = value;
    if (value > high) high = value;
  }
  return { name, isParameter: parameter, values: numbers, low, high };
}

/** The study that the program has written. `token`: of the server, if there is one. */
export function readStudy(text: string, token: string | null): Study {
  const written = JSON.parse(text) as Written;
  const columns = written.columns.map(columnOf).filter(({ low, high }) => low <= high);
  const replay: Replay = token !== null ? { how: "served", token }
    : written.kept !== null ? { how: "kept", folder: written.kept } : { how: "command" };
  return {
    name: written.name, file: written.file, total: written.total, runs: written.runs, reasons: written.reasons, columns, replay,
    status: written.status.map((status) => written.statuses[status]),
    main: Math.max(0, columns.findIndex(({ name }) => name === written.main)),
  };
}

/** Where a value lies between the least and the greatest of its column: 0 to 1; the middle if all are equal. */
export function shareOf({ low, high }: Column, value: number): number {
  return high > low ? (value - low) / (high - low) : 0.5;
}

/** Round numbers from low to high, about as many as asked for. */
export function ticks(low: number, high: number, count: number): number[] {
  const span = high - low;
  if (!(span > 0)) return [low];
  const rough = span / count, power = 10 ** Math.floor(Math.log10(rough));
  const step = power * ([1, 2, 5, 10].find((factor) => factor * power >= rough) ?? 10);
  const marks: number[] = [], first = Math.ceil(low / step);
  // Where the span is in the last digits of the values, first + k is no other number than first: the ends have to do.
  if (first + 1 === first) return [low, high];
  for (let k = 0; (first + k) * step <= high + 1e-9 * span; ++k) marks.push((first + k) * step);
  return marks;
}

/** What replays a run: an address, or a command for a terminal. */
export function replayOf(study: Study, run: number): { address: string } | { command: string } {
  const { replay } = study;
  if (replay.how === "served") return { address: `/run/${run}?token=${replay.token}` };
  if (replay.how === "kept") return { address: `${replay.folder}/run_${run}.html` };
  return { command: `rigor study ${quoted(study.file)} --run ${run} -o run_${run}.html` };
}

function quoted(text: string): string {
  return /^[\w./-]+$/.test(text) ? text : `'${text.replace(/'/g, `'\\''`)}'`;
}

export const number = (value: number): string => format.number(value, 6);
