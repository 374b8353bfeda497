import { polygonThing } from '../algorithm/pointed.js';
import { point } from '../language/words.js';
import { point as dot } from '../picture/mark.js';
import { inOrder, stepsOf } from '../predict/ahead.js';
import type { Asker } from '../predict/asker.js';
import { clippingAt } from './pieces.js';

/** More points would be confusing. */
const mostPoints = 12;

/** The other points of a loop in order, starting after this one; null if it does not occur exactly once on one loop. */
function afterStart(
  loops: readonly (readonly string[])[],
  start: string,
): readonly string[] | null {
  const [loop = [], ...others] = loops.filter((each) => each.includes(start));
  const at = loop.indexOf(start);
  if (at < 0 || others.length > 0 || loop.lastIndexOf(start) !== at) return null;
  return [...loop.slice(at + 1), ...loop.slice(0, at)];
}

/** In which order does the walk go around the part inside the clip polygon? */
export const walk: Asker<'walk'> = {
  from: 'signs',
  at: ['call'],
  ask(trace, step) {
    const clipping = clippingAt(trace, step);
    if (clipping === null) return null;
    const { clip, outline, result } = clipping;
    const until = result.step;
    const enters = stepsOf(trace, step, until, 'entering');
    const leaves = stepsOf(trace, step, until, 'leaving');
    const [start] = enters.map(({ event }) => point(event.point));
    const places = new Map(
      [...outline.map(({ from }) => from), ...clip[1].flat()].map((at) => [point(at), at]),
    );
    const points = [...places.keys()];
    const { polygon, inside } = result.event;
    if (start === undefined || points.length > mostPoints) return null;
    const way = afterStart(
      inside.map((loop) => loop.map(point)),
      start,
    );
    const numberOf = (at: string): string => String(points.indexOf(at) + 1);
    if (way?.every((at) => points.includes(at)) !== true) return null;
    return {
      kind: 'walk',
      step,
      until,
      about: { polygon, clip: clip[0], from: numberOf(start) },
      parts: [
        {
          asks: 'walked',
          options: [...places].map(([name, at]) => ({
            value: numberOf(name),
            places: [dot('pointed', at)],
          })),
          right: way.map(numberOf),
          given: [...places].map(([name, at]) => ({
            value: numberOf(name),
            of: 'vertex',
            note: ({ numbers: write }) => write.point(at),
          })),
        },
      ],
      because: inOrder(enters, leaves, [result]),
      things: [polygon, clip[0]].map(polygonThing),
    };
  },
};
