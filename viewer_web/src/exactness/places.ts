import type { Point } from '../trace/values.js';

/** Places of a map in a row; the place that was decided about is in the middle. */
export const side = 49;
export const middle = (side - 1) / 2;

/** How many bits the numbers of a kernel have, for the distance of neighbouring ones. */
function bitsOf(kernel: string): number {
  if (kernel === 'float') return 24;
  const [, bits] = /^bits:(\d+)$/.exec(kernel) ?? [];
  return bits === undefined ? 53 : Number(bits);
}

/** The distance of the kernel's numbers around this one: an ulp. */
export function ulp(value: number, kernel: string): number {
  let exponent = Math.floor(Math.log2(Math.abs(value)));
  if (2 ** (exponent + 1) <= Math.abs(value)) exponent++; // the logarithm is rounded
  if (2 ** exponent > Math.abs(value)) exponent--;
  return 2 ** (exponent + 1 - bitsOf(kernel));
}

/** Whether a + b is a double without rounding: what a sum lost is found by Knuth's two-sum. */
function isExact(a: number, b: number): boolean {
  const sum = a + b;
  const part = sum - a;
  return a - (sum - part) === 0 && b - part === 0;
}

export interface Places {
  /** The first place, at the lower left. */
  readonly p: Point;
  readonly step: number;
}

/** The file's reader wants this many to be doubles, in each direction from the first. */
const asked = 256;

/**
 * Places around a point: its neighbours in the kernel's numbers, by the greater coordinate; null if the doubles around the
 * other one are not as close.
 */
export function placesAround([x, y]: readonly [number, number], kernel: string): Places | null {
  const greatest = Math.max(Math.abs(x), Math.abs(y));
  const step = ulp(greatest === 0 ? 1 : greatest, kernel);
  const starts = [x - middle * step, y - middle * step] as const;
  const areDoubles = (start: number, at: number): boolean =>
    start + middle * step === at &&
    Array.from({ length: asked }, (_, i) => isExact(start, i * step)).every(Boolean);
  if (!areDoubles(starts[0], x) || !areDoubles(starts[1], y)) return null;
  return { p: starts, step };
}
