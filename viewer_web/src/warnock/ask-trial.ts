import { polygonThing, windowThing } from '../algorithm/pointed.js';
import { eventAt, inOrder, nextOf, stepsOf } from '../predict/ahead.js';
import { edgeNote, signBy, signOptions } from '../predict/asker.js';
import type { Asker } from '../predict/asker.js';
import { none } from '../predict/question.js';
import { corners, hasThreeLists } from '../trace/events.js';

/** Does an edge meet the window, by the signs of its line at the corners? */
export const trial: Asker<'trial'> = {
  isOf: hasThreeLists,
  from: 'signs',
  at: ['call'],
  ask(trace, step) {
    if (eventAt(trace, step, 'call')?.of !== 'TrialFunction') return null;
    const result = nextOf(trace, step, 'meets', 'call');
    const window = trace.timeline.seek(step).values.warnock?.window ?? null;
    const polygon = trace.header.scene.byId.get(result?.event.polygon ?? '');
    if (result === null || window === null || polygon === undefined) return null;
    const trials = stepsOf(trace, step, result.step, 'trial');
    const edge = trials[0]?.event.edge ?? 0;
    const first = stepsOf(trace, step, trials[0]?.step ?? step, 'orient');
    if (first.length !== corners.length) return null;
    const met = trials.find(({ event }) => event.meets);
    return {
      kind: 'trial',
      step,
      until: result.step,
      about: { polygon: polygon.id, edge, window },
      parts: [
        {
          asks: 'cornerSigns',
          options: signOptions,
          right: first.map(({ event }) => signBy[event.sign]),
          decidedBy: (_, at) => first[at]?.step,
          given: corners.map((value) => ({ value, of: 'corner' })),
        },
        {
          asks: 'meetsFirst',
          options: [
            ...polygon.vertices.map((_, each) => ({
              value: String(each),
              note: edgeNote(polygon, each),
            })),
            { value: none },
          ],
          right: [met === undefined ? none : String(met.event.edge)],
        },
      ],
      because: inOrder(first, trials, [result]),
      things: [polygonThing(polygon.id), windowThing(window)],
    };
  },
};
