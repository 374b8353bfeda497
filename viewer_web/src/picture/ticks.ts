/** The distance of numbers on an axis: 1, 2, 5, 10, 20, 50 and so on, at least a given distance. */
export function stepOf(least: number): number {
  for (let ten = 1; ; ten *= 10) {
    const found = [1, 2, 5].find((n) => n * ten >= least);
    if (found !== undefined) return found * ten;
  }
}

/** The numbers on an axis in a range, at least a given distance apart. */
export function ticksIn(first: number, last: number, least: number): number[] {
  const step = stepOf(least);
  const start = Math.ceil(first / step) * step;
  const count = Math.max(0, Math.floor((last - start) / step) + 1);
  return Array.from({ length: count }, (_, i) => start + i * step);
}
