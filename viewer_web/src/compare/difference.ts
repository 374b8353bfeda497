import type { Line } from '../replay/lines.js';
import { differenceOf } from '../picture/layers.js';
import type { Grid } from '../replay/grid.js';
import type { Trace } from '../replay/trace.js';

/** The picture after a step, as a copy. */
export function pictureAt({ timeline }: Trace, step: number): Grid<number> {
  return timeline.seek(step).screen.picture.copy();
}

/** The number of pixels that differ between two pictures; null if their sizes differ. */
export function differing(one: Grid<number>, other: Grid<number>): number | null {
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

/** The number of columns of all curves over which only one of two runs has a line. */
export function differingColumns(one: readonly Line[], other: readonly Line[]): number {
  const [drawn, drawnThere] = [drawnOver(one), drawnOver(other)];
  const both = [...drawn].filter((each) => drawnThere.has(each)).length;
  return drawn.size + drawnThere.size - 2 * both;
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
    : differingColumns(one.timeline.lines.at(step), other.timeline.lines.at(otherStep));
}
