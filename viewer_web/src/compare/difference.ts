import type { Line } from '../replay/values.js';
import { toNumber } from '../language/words.js';
import { differenceOf } from '../picture/layers.js';
import type { Pixels } from '../replay/screen.js';
import type { Trace } from '../replay/trace.js';

/** The picture after a step. */
export function pictureAt({ timeline }: Trace, step: number): Pixels {
  return timeline.seek(step).screen.picture;
}

/** The number of pixels that differ between two pictures; null if their sizes differ. */
export function differing(one: Pixels, other: Pixels): number | null {
  if (one.width !== other.width || one.height !== other.height) return null;
  const { wrong, lacking } = differenceOf(one, other);
  return wrong + lacking;
}

/** Each curve with each column over which it is drawn. */
function drawnOver(lines: readonly Line[]): ReadonlySet<string> {
  const drawn = new Set<string>();
  for (const { curve, columns } of lines) {
    for (let x = columns[0]; x <= columns[1]; x++) drawn.add(`${curve} ${x}`);
  }
  return drawn;
}

/** For each curve and column, how much of the way to the next column is drawn: from 0 to 1. */
function drawnAfter(lines: readonly Line[]): ReadonlyMap<string, number> {
  const drawn = new Map<string, number>();
  for (const { curve, from, to } of lines) {
    const [begin, end] = [toNumber(from[0]), toNumber(to[0])].sort((a, b) => a - b);
    if (begin === undefined || end === undefined) continue;
    for (let x = Math.floor(begin); x < end; x++) {
      const part = Math.min(end, x + 1) - Math.max(begin, x);
      const column = `${curve} ${x}`;
      drawn.set(column, (drawn.get(column) ?? 0) + part);
    }
  }
  return drawn;
}

/** Far less than a pixel, and far more than the rounding of a sum of parts. */
const visible = 1e-6;

/**
 * The number of columns of all curves over which only one of two runs has a line. If both have one over a column and the
 * next, but a gap between them in only one run, that counts as a column, too.
 */
export function differingColumns(one: readonly Line[], other: readonly Line[]): number {
  const [drawn, drawnThere] = [drawnOver(one), drawnOver(other)];
  const [after, afterThere] = [drawnAfter(one), drawnAfter(other)];
  const differs = (column: string): boolean => drawn.has(column) !== drawnThere.has(column);
  const isGap = (column: string): boolean => {
    const [curve, x] = column.split(' ');
    const change = Math.abs((after.get(column) ?? 0) - (afterThere.get(column) ?? 0));
    return change > visible && !differs(column) && !differs(`${curve} ${Number(x) + 1}`);
  };
  const columns = new Set([...drawn, ...drawnThere]);
  const between = new Set([...after.keys(), ...afterThere.keys()]);
  return [...columns].filter(differs).length + [...between].filter(isGap).length;
}

/** How much two runs differ after these steps, in pixels or in columns; null if they cannot be compared. */
export function differenceAt(
  one: Trace,
  step: number,
  other: Trace,
  otherStep: number,
): number | null {
  const [curves, curvesThere] = [one.header.scene.curves, other.header.scene.curves];
  if ((curves === null) !== (curvesThere === null)) return null;
  return curves === null
    ? differing(pictureAt(one, step), pictureAt(other, otherStep))
    : differingColumns(one.timeline.linesAt(step), other.timeline.linesAt(otherStep));
}
