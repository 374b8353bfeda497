import { toColor } from '../replay/screen.js';
import type { Pixels } from '../replay/screen.js';
import type { Area } from '../trace/header.js';
import { boxData } from './shapes.js';

/** Pixels of one colour, as path data of rectangles that do not overlap. */
export interface Patch {
  readonly color: string;
  readonly d: string;
}

interface Run {
  readonly pixel: number;
  readonly first: number;
  readonly end: number;
  readonly top: number;
}

function* runsOf(row: ArrayLike<number>, top: number): Generator<Run> {
  for (let first = 0, end = 0; first < row.length; first = end) {
    const pixel = row[first] ?? 0;
    do end++;
    while (end < row.length && row[end] === pixel);
    yield { pixel, first, end, top };
  }
}

/**
 * The picture as vectors in the plane: runs of equal pixels, joined where the next row has the same run. The colours are in
 * the order of their first occurrence, from the top.
 */
export function patchesOf(picture: Pixels, area: Area): readonly Patch[] {
  const data = new Map<number, string[]>();
  const close = ({ pixel, first, end, top }: Run, bottom: number): void => {
    const box = [area.x + first, area.y + top, end - first, bottom - top] as const;
    data.get(pixel)?.push(boxData(box));
  };
  let open = new Map<number, Run>();
  for (let j = 0; j < picture.height; j++) {
    if (picture.repeats(j)) continue;
    const row = picture.row(j);
    const above = open;
    open = new Map();
    for (const run of runsOf(row, j)) {
      if (!data.has(run.pixel)) data.set(run.pixel, []);
      const same = above.get(run.first);
      const goesOn = same?.end === run.end && same.pixel === run.pixel;
      open.set(run.first, goesOn ? same : run);
      if (goesOn) above.delete(run.first);
    }
    for (const run of above.values()) close(run, j);
  }
  for (const run of open.values()) close(run, picture.height);
  return [...data].map(([pixel, boxes]) => ({ color: toColor(pixel), d: boxes.join('') }));
}
