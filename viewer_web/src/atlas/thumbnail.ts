import { toNumber } from '../language/words.js';
import type { Shape } from '../picture/shapes.js';
import { patchesOf } from '../picture/patches.js';
import { boxData, pathData } from '../picture/shapes.js';
import { outlineData } from '../picture/still.js';
import type { Trace } from '../replay/trace.js';
import { outlines } from '../trace/polygon.js';
import type { Point } from '../trace/values.js';
import type { Rectangle } from '../picture/frame.js';

/** A small picture of the result of a run, in the plane of its scene. */
export interface Thumbnail {
  readonly shown: Rectangle;
  readonly shapes: readonly Shape[];
}

type Pair = readonly [number, number];
const numbers = ([x, y]: Point): Pair => [toNumber(x), toNumber(y)];

/** The painted pixels, with a frame around the wrong one; for curves, the lines drawn. */
export function thumbnailOf({ header: { scene }, timeline }: Trace, wrong: Pair | null): Thumbnail {
  const { area, polygons, curves } = scene;
  const { length } = timeline;
  const shown = [area.x, area.y, area.width, area.height] as const;
  if (curves !== null) {
    const lines = timeline.linesAt(length);
    const ends = lines.map(({ from, to }) => pathData([numbers(from), numbers(to)], false));
    // Half a pixel, because the samples lie on the centres of columns.
    const [x, y, width, height] = shown;
    return {
      shown: [x - 0.5, y - 0.5, width, height],
      shapes: [{ look: 'line', d: ends.join('') }],
    };
  }
  const outlineOf = outlines(polygons);
  const patches = patchesOf(timeline.seek(length).screen.picture, area);
  return {
    shown,
    shapes: [
      ...patches.map(({ color, d }) => ({ look: 'patch', d, fill: color })),
      ...polygons.map((polygon) => ({
        look: 'outline',
        d: outlineData(outlineOf(polygon)),
        color: polygon.color,
      })),
      ...(wrong === null ? [] : [{ look: 'wrong', d: boxData([...wrong, 1, 1]) }]),
    ],
  };
}
