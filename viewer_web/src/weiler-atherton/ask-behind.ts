import { polygonThing } from '../algorithm/pointed.js';
import { relationBy, toNumber } from '../language/words.js';
import { eventAt, inOrder, nextOf, stepsOf } from '../predict/ahead.js';
import { mostOptions, optionsOf, relationOptions } from '../predict/asker.js';
import type { Asker } from '../predict/asker.js';
import { becomes } from '../predict/question.js';
import type { Option, Part } from '../predict/question.js';
import type { Piece } from '../trace/values.js';
import { boundsOf } from './geometry.js';

/** A part, described by its bounding box. */
function optionOf([id, region]: Piece): Option {
  const { from, to } = boundsOf(region);
  return { value: id, note: ({ numbers: { point } }) => `${point(from)} – ${point(to)}` };
}

/** Which inside parts does the clip polygon hide, and is it then visible? */
export const behind: Asker<'behind'> = {
  from: 'polygons',
  at: ['call'],
  ask(trace, step) {
    if (eventAt(trace, step, 'call')?.of !== 'RemoveBehind') return null;
    const result = nextOf(trace, step, 'nearer_ones', 'pop_list');
    const { inHand = null } = trace.timeline.seek(step).values.weilerAtherton ?? {};
    const clip = inHand?.pieces[0];
    if (result === null || inHand === null || clip === undefined) return null;
    const parts = inHand.inside.filter(([, , ground]) => !ground);
    const ids = new Set(parts.map(([id]) => id));
    const areTold = parts.every(([, region]) => region.flat(2).every(isTold));
    if (parts.length === 0 || ids.size < parts.length || !areTold) return null;
    if (parts.length > mostOptions) return null;
    const until = result.step;
    const compared = stepsOf(trace, step, until, 'behind');
    const [only] = compared;
    const depth: Part | null =
      only === undefined || compared.length > 1
        ? null
        : {
            asks: 'partDepth',
            options: relationOptions,
            right: [relationBy[only.event.order]],
          };
    const isVisible = result.event.polygons.length === 0;
    return {
      kind: 'behind',
      step,
      until,
      about: { clip: clip[0] },
      parts: [
        ...(depth === null ? [] : [depth]),
        {
          asks: 'hidden',
          options: parts.map(optionOf),
          right: compared.filter(({ event }) => event.behind).map(({ event }) => event.polygon),
        },
        { asks: 'next', options: optionsOf(becomes), right: [isVisible ? 'visible' : 'again'] },
      ],
      because: inOrder(stepsOf(trace, step, until, 'depth'), compared, [result]),
      things: [clip[0], ...ids].map(polygonThing),
    };
  },
};

const isTold = (value: Parameters<typeof toNumber>[0]): boolean => Number.isFinite(toNumber(value));
