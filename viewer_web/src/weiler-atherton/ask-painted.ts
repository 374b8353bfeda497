import { polygonThing } from '../algorithm/pointed.js';
import { relationBy } from '../language/words.js';
import { eventAt } from '../predict/ahead.js';
import { cellsOf, relationOptions } from '../predict/asker.js';
import type { Asker } from '../predict/asker.js';

/** Which of two polygons is the nearer at a pixel that belongs to regions of both? */
export const painted: Asker<'painted'> = {
  from: 'signs',
  at: ['row', 'order'],
  ask(trace, step) {
    const next = eventAt(trace, step + 1, 'order');
    if (next === null) return null;
    const { polygon, other, point, z, otherZ, order } = next;
    const right = cellsOf([z, otherZ]);
    if (right === null) return null;
    return {
      kind: 'painted',
      step,
      until: step + 1,
      about: { polygon, other, point },
      parts: [
        { asks: 'bothDepths', options: [], right },
        { asks: 'nearerThere', options: relationOptions, right: [relationBy[order]] },
      ],
      because: [step + 1],
      things: [polygon, other].map(polygonThing),
    };
  },
};
