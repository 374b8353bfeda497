import type { Area } from '../trace/header.js';
import type { Box } from '../trace/values.js';
import type { Grid } from './grid.js';
import type { Sight } from './quadtree.js';

/** Flags: the sides of its smallest window that a pixel touches. */
const left = 1;
const right = 2;
const upper = 4;
const lower = 8;

const isAt = (sides: number | undefined, side: number): boolean => ((sides ?? 0) & side) !== 0;

/** Records a window of whole pixels, cut anywhere; it replaces what its pixels had before. */
export function cut(cuts: Grid<number>, { x, y }: Area, window: Box): void {
  const [i, j] = [window[0] - x, window[1] - y];
  const [end, bottom] = [i + window[2], j + window[3]];
  for (let row = j; row < bottom; row++) {
    const sides = (row === j ? upper : 0) | (row === bottom - 1 ? lower : 0);
    cuts.fill(i, row, window[2], 1, sides);
    cuts.set(i, row, sides | left | (end === i + 1 ? right : 0));
    if (end > i + 1) cuts.set(end - 1, row, sides | right);
  }
}

/**
 * The windows into which the area is cut, except those too small to distinguish. This leaves out a window that is being
 * cut, since its first part begins at the same place.
 */
export function pieces(cuts: Grid<number>, { x, y }: Area, { least }: Sight): readonly Box[] {
  const found: Box[] = [];
  for (let j = 0; j < cuts.height; j++) {
    const row = cuts.row(j);
    for (let i = 0; i < cuts.width; i++) {
      if (!isAt(row[i], left) || !isAt(row[i], upper)) continue;
      const [width, height] = [widthFrom(cuts, i, j), heightFrom(cuts, i, j)];
      if (Math.min(width, height) >= least) found.push([x + i, y + j, width, height]);
    }
  }
  return found;
}

function widthFrom(cuts: Grid<number>, i: number, j: number): number {
  const row = cuts.row(j);
  let last = i;
  while (last < cuts.width - 1 && !isAt(row[last], right)) last++;
  return last - i + 1;
}

function heightFrom(cuts: Grid<number>, i: number, j: number): number {
  let last = j;
  while (last < cuts.height - 1 && !isAt(cuts.at(i, last), lower)) last++;
  return last - j + 1;
}
