import { runColors } from "./colors";
import type { RecordedSource } from "./source";

/** Names of the runs of a page; of those without, their numbers. */
export function runNames(sources: RecordedSource[]): string[] {
  return sources.map(({ header }, i) => header.label ?? `run ${i + 1}`);
}

/** The names without their keys, where these are the same in all: "ratio, 0.5" for "method.toi=ratio, run.step=0.5". */
export function shortNames(names: string[]): string[] {
  const key = /[^\s,=]+=/g;
  const keysOf = (name: string) => (name.match(key) ?? []).join();
  return names.every((name) => keysOf(name) === keysOf(names[0])) ? names.map((name) => name.replace(key, "")) : names;
}

/** Colour of a run in the plots. */
export function runColor(run: number): string {
  return runColors[run % runColors.length];
}
