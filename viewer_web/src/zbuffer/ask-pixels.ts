import { pixelThing } from '../algorithm/pointed.js';
import { box } from '../picture/mark.js';
import { inOrder, nextOf, stepsOf } from '../predict/ahead.js';
import { mostOptions, relationOf, relationOptions } from '../predict/asker.js';
import type { Asker } from '../predict/asker.js';

/** At which pixels of this row is the polygon nearer than the stored depth? */
export const pixels: Asker<'pixels'> = {
  from: 'signs',
  at: ['columns'],
  ask(trace, step) {
    const span = nextOf(trace, step, 'span', 'call');
    if (span === null) return null;
    const told = stepsOf(trace, step, span.step, 'pixel').map((at) => {
      const { z, stored, shown } = at.event;
      return { ...at, ...at.event, relation: relationOf(z, stored, shown, trace.header) };
    });
    const contested = told.filter(({ stored, relation }) => stored !== '-inf' && relation !== null);
    // The pixels around a change from visible to hidden.
    const change = contested.findIndex(
      ({ shown }, i) => shown !== contested[i - 1]?.shown && i > 0,
    );
    const first = Math.max(0, Math.min(change - mostOptions / 2, contested.length - mostOptions));
    const asked = contested.slice(first, first + mostOptions);
    const one = asked.find(({ relation }) => relation === '=') ?? asked[step % asked.length];
    const { polygon = null } = trace.timeline.seek(step).values.zbuffer ?? {};
    if (one?.relation == null || asked.length < 2 || polygon === null) return null;
    return {
      kind: 'pixels',
      step,
      until: span.step,
      about: { polygon, row: one.y },
      parts: [
        {
          asks: 'shown',
          options: asked.map(({ x, z, stored }) => ({
            value: String(x),
            places: [box('pointed', [x, one.y, 1, 1])],
            note: ({ numbers: { short } }) => `${short(z)} ? ${short(stored)}`,
          })),
          right: asked.filter(({ shown }) => shown).map(({ x }) => String(x)),
          decidedBy: (column) => asked.find(({ x }) => String(x) === column)?.step,
        },
        {
          asks: 'pixelDepths',
          options: relationOptions,
          right: [one.relation],
          given: [{ value: String(one.x), of: 'column' }],
        },
      ],
      because: inOrder(asked, [span]),
      things: [pixelThing([one.x, one.y])],
    };
  },
};
