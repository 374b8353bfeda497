import { polygonThing } from '../algorithm/pointed.js';
import { eventAt, inOrder, nextOf, stepsOf } from '../predict/ahead.js';
import { mostOptions, optionsOf } from '../predict/asker.js';
import type { Asker } from '../predict/asker.js';
import { ownersOf } from './pieces.js';

/** The greatest offered difference between the numbers of pieces and of polygons. */
const mostMore = 4;

/** Which polygons pierce each other, and how many pieces result? */
export const piercing: Asker<'piercing'> = {
  from: 'polygons',
  at: ['call'],
  ask(trace, step) {
    if (eventAt(trace, step, 'call')?.of !== 'SplitPiercing') return null;
    const result = nextOf(trace, step, 'facets');
    if (result === null) return null;
    const until = result.step;
    const looked = stepsOf(trace, step, until, 'clipped');
    const ids = ownersOf(trace.timeline.seek(step).values.weilerAtherton?.facets ?? []);
    const { length } = result.event.pieces;
    if (looked.length === 0 || ids.length > mostOptions || length > ids.length + mostMore) {
      return null;
    }
    const pierced = stepsOf(trace, step, until, 'pierce');
    const split = stepsOf(trace, step, until, 'split');
    const counts = Array.from({ length: mostMore + 1 }, (_, more) => String(ids.length + more));
    return {
      kind: 'piercing',
      step,
      until,
      about: { polygons: ids },
      parts: [
        {
          asks: 'pierced',
          options: optionsOf(ids),
          right: [...new Set(split.map(({ event }) => event.polygon))],
        },
        { asks: 'pieces', options: optionsOf(counts), right: [String(length)] },
      ],
      because: inOrder(looked, pierced, split, [result]),
      things: ids.map(polygonThing),
    };
  },
};
