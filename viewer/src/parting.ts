import { comparedRows } from "./compare_audits";
import * as format from "./format";
import type { RecordedSource } from "./source";

/** A frame of A at which a body is another way off in B than it can be by rounding. */
export interface Parting {
  time: number;
  body: string;
  distance: number;
}

/** Paths this much apart are different ones, as a part of the scene's extent. */
const noticeable = 1e-4;

/** When and where the paths of the bodies part that two runs have in common; nothing if they stay together. */
export function partingOf(a: RecordedSource, b: RecordedSource): Parting | undefined {
  const placeInB = new Map(b.frames.moving.map((body, i) => [b.header.bodies[body].name, i]));
  const pairs = a.frames.moving.flatMap((body, i) => {
    const own = placeInB.get(a.header.bodies[body].name);
    return own === undefined ? [] : [{ body, inA: i, inB: own }];
  });
  const least = noticeable * a.header.extent;
  const [n, m] = [a.frames.moving.length, b.frames.moving.length];
  for (let k = 0, j = 0; k < a.times.length; ++k) {
    while (j < b.times.length && b.times[j] < a.times[k] * (1 - 1e-9) - 1e-12) ++j;
    if (j === b.times.length) return undefined;
    if (b.times[j] > a.times[k] * (1 + 1e-9) + 1e-12) continue;
    let far: Parting | undefined;
    for (const { body, inA, inB } of pairs) {
      const x = 3 * (k * n + inA), y = 3 * (j * m + inB);
      const off = [0, 1, 2].map((c) => a.frames.position[x + c] + a.header.origin[c] - b.frames.position[y + c] - b.header.origin[c]);
      const distance = Math.hypot(...off);
      if (distance > Math.max(least, far?.distance ?? 0)) far = { time: a.times[k], body: a.header.bodies[body].name, distance };
    }
    if (far) return far;
  }
  return undefined;
}

/** The first run that goes another way than the first one, or the second run if all go the same way. */
export function firstOther(sources: RecordedSource[]): number {
  const other = sources.findIndex((source, i) => i > 0 && partingOf(sources[0], source) !== undefined);
  return other > 0 ? other : 1;
}

/** In words: what was set otherwise in B than in A, and when and where their paths part. */
export function whyOther(a: RecordedSource, b: RecordedSource): string {
  const own = (label: string | undefined) => new Set((label ?? "").split(/,\s+/).filter(Boolean));
  const [ofA, ofB] = [own(a.header.label), own(b.header.label)];
  const changed = [...ofB].filter((part) => !ofA.has(part));
  const before = [...ofA].filter((part) => !ofB.has(part));
  const settings = comparedRows([a.header.audit, b.header.audit]).filter(({ isSetting, differs }) => isSetting && differs[1]);
  const cause = changed.length > 0 ? `${changed.join(", ")} instead of ${before.join(", ") || "what the scene says"}`
    : settings.length > 0 ? settings.map(({ name, values }) => `${name} ${values[1]} instead of ${values[0]}`).join(", ") : "nothing that the audits tell";
  const parting = partingOf(a, b);
  const effect = parting
    ? `The paths part at ${format.number(parting.time, 4)} s: ${parting.body} is ${format.number(parting.distance, 2)} m away.`
    : "No body goes another way, to what the page stores.";
  return `B differs from A by ${cause}. ${effect}`;
}
