import { polygonThing } from '../algorithm/pointed.js';
import { eventAt, inOrder, nextOf, stepsOf } from '../predict/ahead.js';
import { mostOptions, optionsOf } from '../predict/asker.js';
import type { Asker } from '../predict/asker.js';
import { ownersOf } from './pieces.js';

/** Which list is popped from the stack next, and which polygon clips then? A single list would be obvious. */
export const stack: Asker<'stack'> = {
  from: 'polygons',
  at: ['nearer_ones'],
  ask(trace, step) {
    const nearer = eventAt(trace, step, 'nearer_ones');
    const pop = nextOf(trace, step, 'pop_list');
    const { lists = [], inHand = null } = trace.timeline.seek(step).values.weilerAtherton ?? {};
    const clip = inHand?.pieces[0];
    if (nearer === null || pop === null || inHand === null || clip === undefined) return null;
    const ids = ownersOf([...inHand.inside, clip, ...lists.flat()]);
    if (nearer.polygons.length === 0 && lists.length < 2) return null;
    if (ids.length < 2 || ids.length > mostOptions) return null;
    const pushed = stepsOf(trace, step, pop.step, 'push_list');
    const next = pushed.at(-1)?.event.pieces ?? lists.at(-1) ?? [];
    const shown = stepsOf(trace, step, pop.step, 'show');
    return {
      kind: 'stack',
      step,
      until: pop.step,
      about: { clip: clip[0], nearer: [...new Set(nearer.polygons)] },
      parts: [
        { asks: 'clips', options: optionsOf(ids), right: [pop.event.clip] },
        { asks: 'listed', options: optionsOf(ids), right: ownersOf(next) },
      ],
      because: inOrder(shown, pushed, [pop]),
      things: [polygonThing(clip[0])],
    };
  },
};
