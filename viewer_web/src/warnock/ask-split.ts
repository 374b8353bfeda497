import { polygonThing, windowThing } from '../algorithm/pointed.js';
import { eventAt } from '../predict/ahead.js';
import { optionsOf } from '../predict/asker.js';
import type { Asker } from '../predict/asker.js';

/** Is the window split at this vertex, and where? */
export const split: Asker<'split'> = {
  isOf: (method) => method === 'warnock-vertex',
  from: 'polygons',
  at: ['decide', 'split_vertex'],
  ask(trace, step) {
    const next = eventAt(trace, step + 1, 'split_vertex');
    const window = trace.timeline.seek(step).values.warnock?.window ?? null;
    if (next === null || window === null) return null;
    const { polygon, vertex, column, row, splits } = next;
    return {
      kind: 'split',
      step,
      until: step + 1,
      about: { polygon, vertex, window },
      parts: [
        { asks: 'boundaries', options: [], right: [column, row].map(String) },
        { asks: 'splits', options: optionsOf(['yes', 'no']), right: [splits ? 'yes' : 'no'] },
      ],
      because: [step + 1],
      things: [polygonThing(polygon), windowThing(window)],
    };
  },
};
