/** A number with this many significant digits, without needless zeros; thin minus and exponents as they are read. */
export function number(value: number, digits = 5): string {
  if (!Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  const text = size >= 1e5 || size < 1e-3 ? value.toExponential(digits - 1) : value.toPrecision(digits);
  return text.replace(/(\.\d*?)0+(e|$)/, "$1$2").replace(/\.(e|$)/, "$1").replace("e+", "e").replace(/-/g, "−");
}

export function vector(values: ArrayLike<number>, digits = 4): string {
  return Array.from(values, (value) => number(value, digits)).join(", ");
}

/** A time with as many decimals as a step of this size changes. */
export function time(value: number, resolution: number): string {
  const decimals = Math.min(9, Math.max(2, Math.ceil(-Math.log10(resolution || 1))));
  return value.toFixed(decimals);
}

/** "1/1000×", "0.5×" or "10×". */
export function speed(value: number): string {
  return value < 0.5 ? `1/${Math.round(1 / value)}×` : `${value}×`;
}
