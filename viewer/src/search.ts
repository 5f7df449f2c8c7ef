/** Index of the last value that is at most x; 0 if there is none. Values ascend. */
export function lastAtMost(values: ArrayLike<number>, x: number): number {
  let low = 0;
  let high = values.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (values[middle] <= x) low = middle;
    else high = middle - 1;
  }
  return low;
}

/** Index of the value nearest to x, or -1 if there are none. Values ascend. */
export function nearest(values: ArrayLike<number>, x: number): number {
  if (values.length === 0) return -1;
  const i = lastAtMost(values, x);
  return i + 1 < values.length && values[i + 1] - x < x - values[i] ? i + 1 : i;
}
