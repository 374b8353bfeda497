import { polygonThing, windowThing } from '../pointed.js';
import { hasThreeLists } from '../trace/events.js';
import type { Polygon } from '../trace/header.js';
import type { Trace } from '../trace/trace.js';
import type { Box } from '../trace/values.js';
import { eventAt, inOrder, nextOf, stepsOf } from './ahead.js';
import { edgeNote, mostOptions, optionsOf } from './asker.js';
import type { Asker } from './asker.js';
import type { Option } from './question.js';

/** More crossings than a convex outline has. */
const counts = ['0', '1', '2', '3', '4'];
const sums = ['-8', '0', '8'];

interface Asked {
  readonly polygon: Polygon;
  readonly window: Box;
  readonly edges: readonly Option[];
}

/** What the question is about, and the edges to choose from; null where there are too many. */
function askedOf({ header, timeline }: Trace, step: number, id: string): Asked | null {
  const window = timeline.seek(step).values.warnock?.window ?? null;
  const polygon = header.scene.byId.get(id);
  if (window === null || polygon === undefined || polygon.vertices.length > mostOptions)
    return null;
  const edges = polygon.vertices.map((_, edge) => ({
    value: String(edge),
    note: edgeNote(polygon, edge),
  }));
  return { polygon, window, edges };
}

const thingsOf = ({ polygon, window }: Asked): readonly string[] => [
  polygonThing(polygon.id),
  windowThing(window),
];

/** Where does the outline cross the ray? */
export const ray: Asker<'ray'> = {
  isOf: hasThreeLists,
  from: 'signs',
  at: ['call'],
  ask(trace, step) {
    if (eventAt(trace, step, 'call')?.of !== 'RayCrossings') return null;
    const result = nextOf(trace, step, 'crossings', 'pop');
    const asked = result && askedOf(trace, step, result.event.polygon);
    if (result === null || asked === null) return null;
    const seen = stepsOf(trace, step, result.step, 'ray');
    return {
      kind: 'ray',
      step,
      until: result.step,
      about: { polygon: asked.polygon.id, window: asked.window },
      parts: [
        {
          asks: 'crossed',
          options: asked.edges,
          right: seen
            .filter(({ event }) => event.counts > 0)
            .map(({ event }) => String(event.edge)),
        },
        { asks: 'crossings', options: optionsOf(counts), right: [String(result.event.count)] },
      ],
      because: inOrder(seen, [result]),
      things: thingsOf(asked),
    };
  },
};

/** How far does the outline go round the window? */
export const octants: Asker<'octants'> = {
  isOf: hasThreeLists,
  from: 'signs',
  at: ['call'],
  ask(trace, step) {
    if (eventAt(trace, step, 'call')?.of !== 'OctantAngles') return null;
    const result = nextOf(trace, step, 'angle', 'pop');
    const asked = result && askedOf(trace, step, result.event.polygon);
    if (result === null || asked === null) return null;
    const seen = stepsOf(trace, step, result.step, 'octants');
    return {
      kind: 'octants',
      step,
      until: result.step,
      about: { polygon: asked.polygon.id, window: asked.window },
      parts: [
        {
          asks: 'halved',
          options: asked.edges,
          right: seen
            .filter(({ event }) => event.at === 'OA4')
            .map(({ event }) => String(event.edge)),
        },
        { asks: 'sum', options: optionsOf(sums), right: [String(result.event.octants)] },
      ],
      because: inOrder(seen, [result]),
      things: thingsOf(asked),
    };
  },
};
