import { polygonThing } from '../algorithm/pointed.js';
import { toNumber } from '../language/words.js';
import { eventAt } from '../predict/ahead.js';
import { cellsOf } from '../predict/asker.js';
import type { Asker } from '../predict/asker.js';

/** What is the plane of the next polygon? */
export const plane: Asker<'plane'> = {
  from: 'polygons',
  at: ['plane'],
  ask(trace, step) {
    const next = eventAt(trace, step + 1, 'plane');
    if (next === null) return null;
    const [a, b, c, d] = next.plane;
    const right = cellsOf([a, b, d], trace.header);
    if (toNumber(c) === 0 || right === null) return null;
    return {
      kind: 'plane',
      step,
      until: step + 1,
      about: { polygon: next.polygon, c },
      parts: [{ asks: 'plane', options: [], right }],
      because: [step + 1],
      things: [polygonThing(next.polygon)],
    };
  },
};
