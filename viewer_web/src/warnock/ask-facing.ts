import { eventAt, nextOf, stepsOf } from '../predict/ahead.js';
import { mostOptions } from '../predict/asker.js';
import type { Asker } from '../predict/asker.js';

/** Which faces look away from the viewer? */
export const facing: Asker<'facing'> = {
  isOf: (method) => method === 'warnock-bodies',
  from: 'polygons',
  at: ['plane'],
  ask(trace, step) {
    const { scene } = trace.header;
    const begin = nextOf(trace, step, 'push', 'plane');
    if (begin === null || eventAt(trace, step + 1, 'plane') !== null) return null;
    const found = stepsOf(trace, step, begin.step, 'back_face').slice(0, mostOptions);
    const until = found.at(-1)?.step;
    if (until === undefined || found.length < 3) return null;
    return {
      kind: 'facing',
      step,
      until,
      about: {},
      parts: [
        {
          asks: 'away',
          options: found.map(({ event: { polygon } }) => ({
            value: polygon,
            note: ({ numbers: { point } }) =>
              (scene.byId.get(polygon)?.vertices ?? []).map(([x, y]) => point([x, y])).join(' '),
          })),
          right: found.filter(({ event }) => event.away).map(({ event }) => event.polygon),
          decidedBy: (polygon) => found.find(({ event }) => event.polygon === polygon)?.step,
        },
      ],
      because: found.map((each) => each.step),
      things: [],
    };
  },
};
