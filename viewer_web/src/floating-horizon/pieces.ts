import type { Curve, CurveSample } from '../trace/header.js';
import type { Sample } from '../trace/values.js';

export const hasPoint = (sample: CurveSample): sample is Sample => sample[1] !== null;

/** Neighbouring samples with points, at least two: a curve with gaps has several pieces, or none. */
export function piecesOf(curve: Curve): readonly (readonly Sample[])[] {
  const pieces: Sample[][] = [[]];
  for (const sample of curve) {
    if (hasPoint(sample)) pieces.at(-1)?.push(sample);
    else pieces.push([]);
  }
  return pieces.filter(({ length }) => length >= 2);
}
