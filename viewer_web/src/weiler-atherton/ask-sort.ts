import { polygonThing } from '../algorithm/pointed.js';
import { eventAt, inOrder, nextOf, stepsOf } from '../predict/ahead.js';
import { depthOptions, mostOptions, optionsOf } from '../predict/asker.js';
import type { Asker } from '../predict/asker.js';
import type { Piece } from '../trace/values.js';
import { ownersOf } from './pieces.js';

/** With only two depths of two polygons the answer could be guessed. */
const fewestAnswers = 6;

const areSame = (a: Piece | undefined, b: Piece | undefined): boolean =>
  JSON.stringify(a) === JSON.stringify(b);

/** Which polygon is the first by depth, the one that clips all others? */
export const sort: Asker<'sort'> = {
  from: 'polygons',
  at: ['call'],
  ask(trace, step) {
    if (eventAt(trace, step, 'call')?.of !== 'DepthSort') return null;
    const sorted = nextOf(trace, step, 'sorted');
    const facets = trace.timeline.seek(step).values.weilerAtherton?.facets ?? [];
    // The event names only polygons; the list made from them contains the piece.
    const first = sorted && eventAt(trace, sorted.step + 1, 'push_list')?.pieces[0];
    if (sorted === null || first == null) return null;
    const until = sorted.step;
    const greatest = stepsOf(trace, step, until, 'greatest_depth');
    const z = greatest[facets.findIndex((piece) => areSame(piece, first))]?.event.z;
    const all = depthOptions(stepsOf(trace, step, until, 'depth').map(({ event }) => event.z));
    const depths =
      all.length <= mostOptions ? all : depthOptions(greatest.map(({ event }) => event.z));
    const ids = ownersOf(facets);
    if (z === undefined || Math.max(ids.length, depths.length) > mostOptions) return null;
    if (ids.length < 2 || ids.length * depths.length < fewestAnswers) return null;
    return {
      kind: 'sort',
      step,
      until,
      about: { pieces: facets.length },
      parts: [
        { asks: 'first', options: optionsOf(ids), right: [first[0]] },
        { asks: 'depth', options: depths, right: [String(z)] },
      ],
      because: inOrder(greatest, [sorted]),
      things: ids.map(polygonThing),
    };
  },
};
