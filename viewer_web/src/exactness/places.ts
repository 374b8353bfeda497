import type { Point } from '../trace/values.js';

/** Places in a row of a map. The point of the decision is in the middle. */
export const side = 49;
export const middle = (side - 1) / 2;

/** The number of significant bits of a kernel, which determines the distance of neighbouring numbers. */
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

/** Whether a + b is a double without rounding; Knuth's two-sum computes the rounding error. */
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

/** The reader of the file requires this many places in each direction from the first to be doubles. */
const asked = 256;

/**
 * Places around a point, one ulp of the greater coordinate apart in the kernel's numbers. Null if the places of the other
 * coordinate are not doubles.
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
