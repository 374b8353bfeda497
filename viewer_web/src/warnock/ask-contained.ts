import { polygonThing, windowThing } from '../algorithm/pointed.js';
import { eventAt, inOrder, nextOf, stepsOf } from '../predict/ahead.js';
import type { Step } from '../predict/ahead.js';
import { edgeNote, mostOptions, optionsOf } from '../predict/asker.js';
import type { Asker } from '../predict/asker.js';
import type { Option, Part, Question } from '../predict/question.js';
import type { Trace } from '../replay/trace.js';
import { hasThreeLists } from '../trace/events.js';
import type { Event } from '../trace/events.js';

/** More crossings than a convex outline can have. */
const counts = ['0', '1', '2', '3', '4'];
const sums = ['-8', '0', '8'];

/** The examination of an outline that may contain the window, edge by edge, with its result. */
interface Look<E extends 'ray' | 'octants', R extends 'crossings' | 'angle'> {
  /** The common fields of all questions about it. */
  readonly asked: Pick<Question<E>, 'step' | 'until' | 'about' | 'because' | 'things'>;
  /** The edges to choose from. */
  readonly options: readonly Option[];
  readonly edges: readonly Step<E>[];
  readonly result: Event<R>;
}

/** The examination that a call of a procedure begins; null if there is none, or there are too many edges to choose from. */
function lookAt<E extends 'ray' | 'octants', R extends 'crossings' | 'angle'>(
  trace: Trace,
  step: number,
  procedure: 'RayCrossings' | 'OctantAngles',
  [edge, end]: readonly [E, R],
): Look<E, R> | null {
  if (eventAt(trace, step, 'call')?.of !== procedure) return null;
  const { header, timeline } = trace;
  const result = nextOf(trace, step, end, 'pop');
  const found: Event<'crossings' | 'angle'> | undefined = result?.event;
  const polygon = found && header.scene.byId.get(found.polygon);
  const window = timeline.seek(step).values.warnock?.window ?? null;
  if (!result || !polygon || window === null || polygon.vertices.length > mostOptions) return null;
  const edges = stepsOf(trace, step, result.step, edge);
  return {
    asked: {
      step,
      until: result.step,
      about: { polygon: polygon.id, window },
      because: inOrder(edges, [result]),
      things: [polygonThing(polygon.id), windowThing(window)],
    },
    options: polygon.vertices.map((_, i) => ({ value: String(i), note: edgeNote(polygon, i) })),
    edges,
    result: result.event,
  };
}

type Edge = Step<'ray' | 'octants'>;

const numberOf = ({ event }: Edge): string => String(event.edge);

/** The part that asks for some of the edges. */
const edgesPart = (
  asks: 'crossed' | 'halved',
  options: readonly Option[],
  edges: readonly Edge[],
  right: readonly Edge[],
): Part => ({
  asks,
  options,
  right: right.map(numberOf),
  decidedBy: (value) => edges.find((each) => numberOf(each) === value)?.step,
});

const where = { isOf: hasThreeLists, from: 'signs', at: ['call'] } as const;

/** Where does the outline cross the ray? */
export const ray: Asker<'ray'> = {
  ...where,
  ask(trace, step) {
    const look = lookAt(trace, step, 'RayCrossings', ['ray', 'crossings']);
    if (look === null) return null;
    const { asked, options, edges, result } = look;
    const crossed = edges.filter(({ event }) => event.counts > 0);
    return {
      kind: 'ray',
      ...asked,
      parts: [
        edgesPart('crossed', options, edges, crossed),
        { asks: 'crossings', options: optionsOf(counts), right: [String(result.count)] },
      ],
    };
  },
};

/** By what angle does the outline turn around the window? */
export const octants: Asker<'octants'> = {
  ...where,
  ask(trace, step) {
    const look = lookAt(trace, step, 'OctantAngles', ['octants', 'angle']);
    if (look === null) return null;
    const { asked, options, edges, result } = look;
    const halved = edges.filter(({ event }) => event.at === 'OA4');
    return {
      kind: 'octants',
      ...asked,
      parts: [
        edgesPart('halved', options, edges, halved),
        { asks: 'sum', options: optionsOf(sums), right: [String(result.octants)] },
      ],
    };
  },
};
