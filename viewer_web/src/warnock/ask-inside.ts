import { cornerThing, polygonThing } from '../algorithm/pointed.js';
import { eventAt, inOrder, nextOf, stepsOf } from '../predict/ahead.js';
import { edgeNote, optionsOf, signBy, signOptions } from '../predict/asker.js';
import type { Asker } from '../predict/asker.js';
import { cornerAt } from './naming.js';

/** With fewer edges the answer is obvious. */
const fewestEdges = 3;

/** Is this point inside? */
export const inside: Asker<'inside'> = {
  from: 'signs',
  at: ['call'],
  ask(trace, step) {
    if (eventAt(trace, step, 'call')?.of !== 'SurroundTest') return null;
    const result = nextOf(trace, step, 'surround', 'call');
    if (result === null) return null;
    const { polygon: id, point, inside: isInside } = result.event;
    const polygon = trace.header.scene.byId.get(id);
    const tests = stepsOf(trace, step, result.step, 'orient');
    if (polygon === undefined || tests.length < fewestEdges) return null;
    if (tests.some(({ event }) => event.at === 'ED3')) return null; // edge-on: the point is collinear with all edges

    const last = polygon.vertices.length - 1;
    const edges = [last, ...Array.from({ length: last }, (_, i) => i)];
    const { warnock } = trace.timeline.seek(step).values;
    const corner = cornerAt(point, warnock?.window ?? null);
    return {
      kind: 'inside',
      step,
      until: result.step,
      about: { polygon: id, point, corner },
      parts: [
        { asks: 'inside', options: optionsOf(['yes', 'no']), right: [isInside ? 'yes' : 'no'] },
        {
          asks: 'signs',
          options: signOptions,
          right: tests.map(({ event }) => signBy[event.sign]),
          decidedBy: (_, at) => tests[at]?.step,
          given: edges.map((edge) => ({
            value: String(edge),
            of: 'edge',
            note: edgeNote(polygon, edge),
          })),
        },
      ],
      because: inOrder(tests, [result]),
      things: [polygonThing(id), ...(corner === null ? [] : [cornerThing(corner)])],
    };
  },
};
