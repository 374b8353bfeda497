import type { Columns } from '../replay/columns.js';
import type { Line } from '../replay/lines.js';
import type { FloatingHorizon } from './state.js';

/** The values of the state in the form in which readers of a trace are compared. */
export function horizonValues(
  { curve, place, edges }: FloatingHorizon,
  { horizons }: Columns,
  lines: readonly Line[],
): object {
  return {
    lines: lines.map((line) => [line.curve, line.from, line.to]),
    curve,
    segment: place.segment,
    previous: place.previous,
    current: place.current,
    leftEdge: edges.left,
    rightEdge: edges.right,
    upper: Array.from(horizons.upper.row(0)),
    lower: Array.from(horizons.lower.row(0)),
  };
}
