/** Runs of a comparison as work and precision: what rigor compare writes into the block `precision`. */
export interface PrecisionPoint {
  label: string;
  /** [s]. */
  step: number;
  /** [s]. */
  cpu_time: number;
  /** [m]. */
  error: number;
  /** Observed against the point before. */
  order: number | null;
}

export interface PrecisionCurve {
  label: string;
  points: PrecisionPoint[];
}

export interface Precision {
  /** What errors are measured against, and what it is wrong by itself [m], as far as that is known. */
  references: { name: string; error: number | null }[];
  curves: PrecisionCurve[];
}

/** A logarithmic axis: where values come to lie between 0 and 1, and what is written on it. */
export interface LogAxis {
  low: number;
  high: number;
  ticks: number[];
}

/** An axis of whole decades that holds the positive values, at most about eight ticks; the first decade below 1 if there are none. */
export function logAxis(values: number[]): LogAxis {
  const positive = values.filter((value) => value > 0 && Number.isFinite(value));
  // Values next to a decade, as 0.01, stay on it whatever their rounding.
  const tiny = 1e-9;
  const first = positive.length > 0 ? Math.floor(Math.log10(Math.min(...positive)) + tiny) : -1;
  const last = Math.max(first + 1, positive.length > 0 ? Math.ceil(Math.log10(Math.max(...positive)) - tiny) + 0 : 0);
  const stride = Math.ceil((last - first) / 8);
  const ticks: number[] = [];
  for (let power = first; power <= last; power += stride) ticks.push(power);
  return { low: first, high: last, ticks };
}

/** Where a positive value lies on the axis, from 0 to 1. */
export function placeOn({ low, high }: LogAxis, value: number): number {
  return (Math.log10(value) - low) / (high - low);
}

/** Points that a logarithmic plot can show: those whose error and x are positive. */
export function shownPoints(curve: PrecisionCurve, x: (point: PrecisionPoint) => number): PrecisionPoint[] {
  return curve.points.filter((point) => point.error > 0 && x(point) > 0);
}

/** The reference's own error, if all references tell one above zero: the largest. */
export function referenceError({ references }: Precision): number | undefined {
  const errors = references.map(({ error }) => error ?? 0).filter((error) => error > 0);
  return errors.length > 0 ? Math.max(...errors) : undefined;
}
