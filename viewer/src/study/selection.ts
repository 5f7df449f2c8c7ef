import type { Study } from "./data";

/** What the reader has chosen: ranges of columns, and one run. All parts of the page listen to it. */
export class Selection {
  /** Lowest and highest value by column. */
  readonly ranges = new Map<number, [number, number]>();
  /** Index of the chosen run among those of the page, or -1. */
  chosen = -1;
  private readonly listeners: (() => void)[] = [];

  constructor(private readonly study: Study) {}

  listen(listener: () => void): void {
    this.listeners.push(listener);
  }

  choose(index: number): void {
    this.chosen = index;
    this.tell();
  }

  /** Keeps the runs whose value of a column is within the range; without one, all. */
  limit(column: number, range?: [number, number]): void {
    if (range) this.ranges.set(column, range);
    else this.ranges.delete(column);
    this.tell();
  }

  clear(): void {
    this.ranges.clear();
    this.tell();
  }

  /** Whether a run is within all ranges. A value that is not known is within none. */
  holds(index: number): boolean {
    for (const [column, [low, high]] of this.ranges) {
      const value = this.study.columns[column].values[index];
      if (!(low <= value && value <= high)) return false;
    }
    return true;
  }

  private tell(): void {
    for (const listener of this.listeners) listener();
  }
}

/** How many runs are within the ranges, and the mean of the main outcome over them. */
export function summary(study: Study, selection: Selection): { count: number; mean: number } {
  const values = study.columns[study.main]?.values ?? new Float64Array();
  let count = 0, known = 0, sum = 0;
  for (let i = 0; i < study.runs.length; ++i) {
    if (!selection.holds(i)) continue;
    ++count;
    if (Number.isFinite(values[i])) ++known, (sum += values[i]);
  }
  return { count, mean: sum / known };
}
