import { cornerThing, polygonThing } from '../algorithm/pointed.js';
import { eventAt, inOrder, nextOf, stepsOf } from '../predict/ahead.js';
import { relationOf, relationOptions } from '../predict/asker.js';
import type { Asker } from '../predict/asker.js';
import { corners as places } from '../trace/events.js';

/** At which corners is this polygon nearer than all before it? */
export const corners: Asker<'corners'> = {
  from: 'polygons',
  at: ['depth'],
  ask(trace, step) {
    const depth = eventAt(trace, step, 'depth');
    const isLast = eventAt(trace, step + 1, 'depth') === null;
    const nearer = nextOf(trace, step, 'nearer', 'depth', 'pop');
    if ((depth?.at !== 'PW5' && depth?.at !== 'HP3') || !isLast || nearer === null) return null;
    const { corners: nearest = null, depths = [] } = trace.timeline.seek(step).values.warnock ?? {};
    if (nearest === null) return null;

    const all = places.map((place, i) => {
      const z = depths[i] ?? 'nan';
      const against = nearest[place];
      const relation = relationOf(z, against, nearer.event.corners.includes(place), trace.header);
      return { place, z, against, relation };
    });
    const contested = all.filter(
      ({ against, relation }) => against !== '-inf' && relation !== null,
    );
    // Equal depths are preferred, because mistakes are likely there; otherwise the corners take turns.
    const equal = contested.find(({ relation }) => relation === '=');
    const one = equal ?? contested[step % contested.length];
    if (one?.relation == null) return null;
    const compared = stepsOf(trace, step, nearer.step, 'compare');
    return {
      kind: 'corners',
      step,
      until: nearer.step,
      about: { polygon: depth.polygon },
      parts: [
        {
          asks: 'nearer',
          options: all.map(({ place, z, against }) => ({
            value: place,
            note: ({ numbers: { short } }) => `${short(z)} ? ${short(against)}`,
          })),
          right: nearer.event.corners,
          decidedBy: (place) => compared.find(({ event }) => event.corner === place)?.step,
        },
        {
          asks: 'cornerDepths',
          options: relationOptions,
          right: [one.relation],
          given: [{ value: one.place, of: 'corner' }],
        },
      ],
      because: inOrder(compared, [nearer]),
      things: [polygonThing(depth.polygon), cornerThing(one.place)],
    };
  },
};
