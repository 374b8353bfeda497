import type { Area } from '../trace/header.js';
import type { Box } from '../trace/values.js';
import type { Grid } from './grid.js';

/** The number of halvings from the first window to this one. A side of 1 or less is not halved. */
export function levelOf([, , width, height]: Box, [, , rootWidth, rootHeight]: Box): number {
  return Math.round(Math.log2(Math.max(rootWidth / width, rootHeight / height)));
}

function halved(side: number, level: number): number {
  let part = side;
  for (let i = 0; i < level && part > 1; i++) part /= 2;
  return part;
}

/** The window of a level that contains a point. */
function windowAt([left, top, width, height]: Box, level: number, x: number, y: number): Box {
  const [w, h] = [halved(width, level), halved(height, level)];
  return [left + Math.floor((x - left) / w) * w, top + Math.floor((y - top) / h) * h, w, h];
}

/** Gives the level of a window to the pixels whose centres it contains. */
export function halve(levels: Grid<number>, area: Area, window: Box, root: Box): void {
  const [x, y, width, height] = window;
  const cell = (at: number, from: number, cells: number): number =>
    Math.min(Math.max(Math.ceil(at - from - 0.5), 0), cells);
  const i = cell(x, area.x, area.width);
  const j = cell(y, area.y, area.height);
  const across = cell(x + width, area.x, area.width) - i;
  const down = cell(y + height, area.y, area.height) - j;
  levels.fill(i, j, across, down, levelOf(window, root));
}

/** The visible part of the plane, and the size that a window must have to be distinguishable. */
export interface Sight {
  readonly shown: readonly [x: number, y: number, width: number, height: number];
  readonly least: number;
}

/**
 * The windows into which the area is divided: those that contain a pixel that is in no smaller window. If they are too
 * small to distinguish, the smallest distinguishable ones that contain them are returned instead.
 */
export function leaves(levels: Grid<number>, root: Box, area: Area, sight: Sight): readonly Box[] {
  const [x, y, width, height] = sight.shown;
  let finest = 0;
  while (finest < 255 && halved(Math.min(root[2], root[3]), finest + 1) >= sight.least) finest++;
  const found = new Map<string, Box>();
  const last = Math.min(levels.height, Math.ceil(y + height - area.y));
  const end = Math.min(levels.width, Math.ceil(x + width - area.x));
  for (let j = Math.max(0, Math.floor(y - area.y)); j < last;) {
    for (let i = Math.max(0, Math.floor(x - area.x)); i < end;) {
      const level = Math.min(levels.at(i, j), finest);
      const window = windowAt(root, level, area.x + i + 0.5, area.y + j + 0.5);
      found.set(`${level} ${window[0]} ${window[1]}`, window);
      i = Math.max(i + 1, Math.ceil(window[0] + window[2] - area.x - 0.5));
    }
    // All rows of the smallest relevant windows contain the same windows.
    const [, top, , high] = windowAt(root, finest, area.x, area.y + j + 0.5);
    j = Math.max(j + 1, Math.ceil(top + high - area.y - 0.5));
  }
  return [...found.values()];
}
