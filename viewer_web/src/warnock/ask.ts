import {
  cornerThing,
  edgeThing,
  pixelThing,
  polygonThing,
  windowThing,
} from '../algorithm/pointed.js';
import type { View } from '../algorithm/view.js';
import { texts } from '../i18n/index.js';
import type { Language } from '../language/language.js';
import { short, toNumber } from '../language/words.js';
import { box, path, point as dot } from '../picture/mark.js';
import { eventAt, inOrder, nextOf, stepsOf } from '../predict/ahead.js';
import type { Step } from '../predict/ahead.js';
import {
  cellsOf,
  comparedNote,
  depthOptions,
  edgeNote,
  mostOptions,
  optionsOf,
  relationOf,
  relationOptions,
  signBy,
  signOptions,
} from '../predict/asker.js';
import type { Asker } from '../predict/asker.js';
import type { Fact } from '../predict/facts.js';
import type { Given, Option, Part, Question } from '../predict/question.js';
import { crossing, none, relations, tests } from '../predict/question.js';
import type { Trace } from '../replay/trace.js';
import type { Warnock } from '../replay/values.js';
import { cases } from '../time/course.js';
import { corners as places, hasThreeLists } from '../trace/events.js';
import type { Event, Method } from '../trace/events.js';
import { planeOf } from '../trace/polygon.js';
import type { Box, N } from '../trace/values.js';
import { cornerAt, ownersOf } from './naming.js';
import { shownIn } from './state.js';
import type { Joined } from './state.js';

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

const valueOf = (window: Box): string => window.join(' ');

const optionOf = (window: Box): Option => ({
  value: valueOf(window),
  note: ({ numbers }) => numbers.windowText(window),
  places: [box('pointed', window)],
});

/** One more than can be right: the popped window itself does not wait any longer. */
const waiting = Array.from({ length: mostOptions + 1 }, (_, n) => String(n));

/** From the upper left on, which does not show the order of the stack. */
const byPlace = ([x, y]: Box, [otherX, otherY]: Box): number => y - otherY || x - otherX;

/** Which window is next, and how many wait after it? */
export const pop: Asker<'pop'> = {
  from: 'windows',
  at: ['push'],
  ask(trace, step) {
    const popped = nextOf(trace, step, 'pop', 'push');
    const { stack = [], window = null } = trace.timeline.seek(step).values.warnock ?? {};
    if (popped === null || window === null) return null;
    if (stack.length < 2 || stack.length > mostOptions) return null;
    return {
      kind: 'pop',
      step,
      until: popped.step,
      about: { divided: window },
      parts: [
        {
          asks: 'popped',
          options: stack
            .map((each) => each.window)
            .sort(byPlace)
            .map(optionOf),
          right: [valueOf(popped.event.window)],
          decidedBy: () => popped.step,
        },
        { asks: 'waiting', options: optionsOf(waiting), right: [String(stack.length - 1)] },
      ],
      because: [popped.step],
      things: [windowThing(window)],
    };
  },
};

/** The line that decided. Above the level of signs the earlier tests may have no event. */
function testOf(trace: Trace, step: number, until: number): (typeof tests)[number] {
  const contained = [
    ...stepsOf(trace, step, until, 'crossings'),
    ...stepsOf(trace, step, until, 'angle'),
  ];
  if (contained.length > 0) return 'RE4';
  if (stepsOf(trace, step, until, 'meets').length > 0) return 'RE3';
  return stepsOf(trace, step, until, 'insider').length > 0 ? 'RE2' : 'RE1';
}

/** What is the relation of this polygon to the window, and which test decides it? */
export const relation: Asker<'relation'> = {
  isOf: hasThreeLists,
  from: 'polygons',
  at: ['call'],
  ask(trace, step) {
    if (eventAt(trace, step, 'call')?.of !== 'Relation') return null;
    const result = nextOf(trace, step, 'relation', 'pop');
    const window = trace.timeline.seek(step).values.warnock?.window ?? null;
    if (result === null || window === null) return null;
    const until = result.step;
    const { polygon } = result.event;
    return {
      kind: 'relation',
      step,
      until,
      about: { polygon, window },
      parts: [
        { asks: 'lies', options: optionsOf(relations), right: [result.event.relation] },
        { asks: 'test', options: optionsOf(tests), right: [testOf(trace, step, until)] },
      ],
      because: inOrder(
        stepsOf(trace, step, until, 'box'),
        stepsOf(trace, step, until, 'insider'),
        stepsOf(trace, step, until, 'meets'),
        stepsOf(trace, step, until, 'crossings'),
        stepsOf(trace, step, until, 'angle'),
        [result],
      ),
      things: [polygonThing(polygon), windowThing(window)],
    };
  },
};

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
    if (first.length !== places.length) return null;
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
          given: places.map((value) => ({ value, of: 'corner' })),
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

/** Which vertices remain after clipping by this side of the window? */
export const clip: Asker<'clip'> = {
  from: 'polygons',
  at: ['clip_side'],
  ask(trace, step) {
    const side = eventAt(trace, step, 'clip_side');
    const list = nextOf(trace, step, 'clip_list', 'clip_result');
    const result = nextOf(trace, step, 'clip_result', 'pop');
    const { clip: begun = null } = trace.timeline.seek(step).values.warnock ?? {};
    if (side === null || list === null || result === null || begun === null) return null;
    const until = list.step;
    const crossed = stepsOf(trace, step, until, 'clip_cross');
    const kept = stepsOf(trace, step, until, 'clip_keep');
    const dropped = stepsOf(trace, step, until, 'clip_drop');
    if (crossed.length + dropped.length === 0) return null;

    // Each vertex in order is kept or dropped, after a crossing of the edge that leads to it.
    const inTurn = inOrder(kept, dropped);
    const entries = inOrder(crossed, kept);
    const right = entries.map((at) =>
      inTurn.includes(at) ? String(inTurn.indexOf(at) + 1) : crossing,
    );
    const vertices = begun.vertices.map((vertex, i): Given => ({
      value: String(i + 1),
      of: 'vertex',
      note: ({ numbers }) => numbers.point(vertex.slice(0, 2)),
      places: [dot('pointed', vertex)],
    }));
    const { length } = vertices;
    const edges = begun.vertices.map((to, i): Option => {
      const before = (i + length - 1) % length;
      const from = begun.vertices[before] ?? to;
      return { value: `${before + 1}–${i + 1}`, places: [path('pointed', [from, to])] };
    });
    const edgeTo = (step: number): string =>
      edges[inTurn.findIndex((at) => at > step)]?.value ?? '';
    const anyEdge: Option = { value: crossing, places: edges.flatMap(({ places = [] }) => places) };
    const { polygon } = result.event;
    return {
      kind: 'clip',
      step,
      until,
      about: { polygon, side: side.side },
      parts: [
        {
          asks: 'cut',
          options: edges,
          right: crossed.map(({ step: at }) => edgeTo(at)),
          given: vertices,
          decidedBy: (edge) => crossed.find(({ step: at }) => edgeTo(at) === edge)?.step,
        },
        {
          asks: 'list',
          options: [...vertices, anyEdge],
          right,
          decidedBy: (_, at) => entries[at],
        },
      ],
      because: inOrder(crossed, kept, dropped, [list]),
      things: [polygonThing(polygon)],
    };
  },
};

/** The polygon that hides the others in a window; null if the trace does not have it. */
function hidingIn(
  trace: Trace,
  decide: Step<'decide'>,
  covers: readonly Step<'cover'>[],
): string | null {
  if (decide.event.case !== 'surrounded') return none;
  const cover = covers.at(-1);
  if (cover !== undefined) return cover.event.polygon;
  const fill = eventAt(trace, decide.step + 1, 'fill');
  if (fill === null) return null;
  const known = trace.timeline.seek(decide.step).values;
  const { polygons, background } = ownersOf(fill, known, trace.header);
  const [owner, ...others] = polygons;
  return owner === undefined || others.length > 0 || background ? null : owner;
}

/**
 * The depths of each polygon's plane at the corners of a window, the upper ones first: the run's numbers, if it computes them
 * for all. If it does not, which of them it has would give away which polygons stay in the list.
 */
function depthsBeside(
  trace: Trace,
  [step, until]: readonly [number, number],
  window: Box,
  ids: readonly string[],
): (id: string) => Option {
  const [x, y, width, height] = window;
  const at = [y, y + height].flatMap((top) => [x, x + width].map((left) => [left, top]));
  const found = stepsOf(trace, step, until, 'depth').map(({ event }) => event);
  const depthsInRun = (id: string): readonly N[] =>
    at.flatMap((corner) => {
      const own = found.find(
        ({ polygon, point }) => polygon === id && String(point) === String(corner),
      );
      return own === undefined ? [] : [own.z];
    });
  const inScene = (id: string): readonly N[] => {
    const polygon = trace.header.scene.byId.get(id);
    if (polygon === undefined) return [];
    const plane = planeOf(polygon);
    return at.map(([left = 0, top = 0]) => Number(plane(left, top).toPrecision(digits)));
  };
  const inRun = new Map(ids.map((id) => [id, depthsInRun(id)]));
  const hasAll = [...inRun.values()].every((each) => each.length === at.length);
  const depths = hasAll ? inRun : new Map(ids.map((id) => [id, inScene(id)]));
  const isShort = at.map((_, i) => {
    const all = new Set([...depths.values()].map((each) => each[i] ?? NaN));
    return new Set([...all].map((z) => short(z))).size === all.size;
  });
  return (value) => ({
    value,
    note: ({ numbers: { short: inShort, inFull } }) =>
      (depths.get(value) ?? [])
        .map((z, i) => (Number.isNaN(toNumber(z)) ? '—' : isShort[i] ? inShort(z) : inFull(z)))
        .join('; '),
  });
}
/** The digits of a depth that the errors of its calculation in doubles do not reach. */
const digits = 12;

/** The procedure that looks for a polygon that hides all others; null if the method has none. */
function seekerOf(method: Method): 'ProcessWindow' | 'HidingPolygon' | null {
  if (hasThreeLists(method)) return 'HidingPolygon';
  return method === 'warnock-simplest' ? null : 'ProcessWindow';
}

/**
 * The steps that show why a polygon is found to hide all others, or why none is: which polygons surround the window, and
 * the numbers of the comparisons by which one of them would have to be the nearest at each corner, up to the first that
 * ends differently.
 */
function foundBy(trace: Trace, step: number, until: number): readonly { readonly step: number }[] {
  const found = stepsOf(trace, step, until, 'nearer');
  const compared = stepsOf(trace, step, until, 'compare').filter(
    ({ event }) => event.at === 'PW6' || event.at === 'HP4',
  );
  const first = found[0]?.event.polygon; // at each corner it is the nearest so far, whatever its depth
  const choices = compared.filter(({ event: { polygon, corner, nearer } }) => {
    const { k = 0, corners: at = [] } =
      found.find(({ event }) => event.polygon === polygon)?.event ?? {};
    if (polygon === first || corner === undefined) return false;
    return k === 4 || k === 0 ? true : nearer === at.includes(corner);
  });
  return [
    ...stepsOf(trace, step, until, 'mark'),
    ...choices,
    ...found,
    ...stepsOf(trace, step, until, 'uncover'),
    ...stepsOf(trace, step, until, 'cover'),
  ];
}

/** Which case is this window? */
export const window: Asker<'window'> = {
  from: 'windows',
  at: ['pop'],
  ask(trace, step) {
    const { detail, scene } = trace.header;
    const isCoarse = detail === 'windows'; // lists then never get shorter than the first one
    const by = seekerOf(trace.header.method);
    if (isCoarse && by === null) return null; // only the case would be asked
    if (isCoarse && scene.polygons.length > mostOptions) return null;
    const pop = eventAt(trace, step, 'pop');
    const decide = nextOf(trace, step, 'decide', 'pop');
    if (pop === null || decide === null) return null;
    const until = decide.step;
    const back = stepsOf(trace, step, until, 'rejoin');
    const now = trace.timeline.seek(back.at(-1)?.step ?? step).values.warnock;
    const ids = (now?.apl?.entries ?? []).map(([id]) => id);
    const shown = now === undefined ? [] : shownIn(now, scene);
    if (ids.length === 0 || shown.length > mostOptions) return null;
    const covers = stepsOf(trace, step, until, 'cover');
    const hiding = hidingIn(trace, decide, covers);
    if (hiding === null) return null;

    const cover = covers.slice(-1);
    const summary = stepsOf(trace, step, until, 'summary');
    const discards = [
      ...stepsOf(trace, step, until, 'discard'),
      ...stepsOf(trace, step, until, 'join'),
    ];
    const gone = discards.map(({ event }) => event.polygon);
    const stay: Part = {
      asks: 'stay',
      options: optionsOf(ids),
      right: ids.filter((id) => !gone.includes(id)),
      decidedBy: (id) =>
        discards.find(({ event }) => event.polygon === id)?.step ?? summary.at(-1)?.step,
    };
    const hides: Part = {
      asks: 'hides',
      options: [
        ...shown.map(depthsBeside(trace, [step, until], pop.window, shown)),
        { value: none },
      ],
      right: [hiding],
      decidedBy: () => cover[0]?.step,
    };
    return {
      kind: 'window',
      step,
      until,
      about: { window: pop.window, by },
      parts: [
        ...(isCoarse ? [] : [stay]),
        ...(by === null ? [] : [hides]),
        { asks: 'case', options: optionsOf(cases), right: [decide.event.case] },
      ],
      because: inOrder(discards, foundBy(trace, step, until), summary, [decide]),
      things: [windowThing(pop.window)],
    };
  },
};

/** Is the window split at this vertex, and where? */
export const split: Asker<'split'> = {
  isOf: (method) => method === 'warnock-vertex',
  from: 'polygons',
  at: ['decide', 'split_vertex'],
  ask(trace, step) {
    const next = eventAt(trace, step + 1, 'split_vertex');
    const window = trace.timeline.seek(step).values.warnock?.window ?? null;
    if (next === null || window === null) return null;
    const { polygon, vertex, column, row, splits } = next;
    return {
      kind: 'split',
      step,
      until: step + 1,
      about: { polygon, vertex, window },
      parts: [
        { asks: 'boundaries', options: [], right: [column, row].map(String) },
        { asks: 'splits', options: optionsOf(['yes', 'no']), right: [splits ? 'yes' : 'no'] },
      ],
      because: [step + 1],
      things: [polygonThing(polygon), windowThing(window)],
    };
  },
};

/** Which polygon is visible at this point, and at which depth? */
export const point: Asker<'point'> = {
  from: 'polygons',
  at: ['call'],
  ask(trace, step) {
    if (eventAt(trace, step, 'call')?.of !== 'PointColor') return null;
    const color = nextOf(trace, step, 'color', 'pop');
    if (color === null) return null;
    const until = color.step;
    const now = trace.timeline.seek(step).values.warnock;
    const window = now?.window ?? null;
    const ids = now === undefined ? [] : shownIn(now, trace.header.scene);
    const depths = stepsOf(trace, step, until, 'depth');
    const options = depthOptions(depths.map(({ event }) => event.z));
    const nearest = stepsOf(trace, step, until, 'nearest');
    const winner = nearest.at(-1)?.event;
    if (winner === undefined || options.length < 2 || ids.length > mostOptions) return null;

    const surrounds = stepsOf(trace, step, until, 'surround');
    const covering = depths.map(({ event }) => event.polygon);
    return {
      kind: 'point',
      step,
      until,
      about: { point: color.event.point },
      parts: [
        {
          asks: 'covers',
          options: optionsOf(ids),
          right: covering,
          decidedBy: (id) => surrounds.find(({ event }) => event.polygon === id)?.step,
        },
        { asks: 'wins', options: optionsOf([...ids, none]), right: [winner.polygon] },
        { asks: 'depth', options, right: [String(winner.z)] },
      ],
      because: inOrder(surrounds, depths, nearest, [color]),
      things: window === null ? [] : [windowThing(window)],
    };
  },
};

/** The planes come first in a run. */
function planeIn(trace: Trace, polygon: string): Event<'plane'>['plane'] | null {
  for (let step = 1; ; step++) {
    const event = eventAt(trace, step, 'plane');
    if (event === null) return null;
    if (event.polygon === polygon) return event.plane;
  }
}

/** What is the depth of this polygon's plane at this point? */
export const depth: Asker<'depth'> = {
  from: 'polygons',
  at: ['count', 'surround'],
  ask(trace, step) {
    const next = eventAt(trace, step + 1, 'depth');
    const plane = next === null ? null : planeIn(trace, next.polygon);
    if (next === null || plane === null) return null;
    const right = cellsOf([next.z], trace.header);
    const isLevel = toNumber(plane[0]) === 0 && toNumber(plane[1]) === 0;
    if (isLevel || right === null) return null;
    const { polygon, point } = next;
    return {
      kind: 'depth',
      step,
      until: step + 1,
      about: { polygon, point, plane },
      parts: [{ asks: 'z', options: [], right }],
      because: [step + 1],
      things: [polygonThing(polygon)],
    };
  },
};

/** How deep is an edge-on polygon at this point? */
export const edgeDepth: Asker<'edgeDepth'> = {
  isOf: (method) => method === 'warnock-edges',
  from: 'polygons',
  at: ['surround'],
  ask(trace, step) {
    if (eventAt(trace, step + 1, 'edge_depth') === null) return null;
    const result = nextOf(trace, step, 'depth', 'call', 'pop');
    const polygon = trace.header.scene.byId.get(result?.event.polygon ?? '');
    const right = result === null ? null : cellsOf([result.event.z], trace.header);
    if (result === null || polygon === undefined || right === null) return null;
    const edges = stepsOf(trace, step, result.step, 'edge_depth');
    return {
      kind: 'edgeDepth',
      step,
      until: result.step,
      about: { polygon: polygon.id, point: result.event.point },
      parts: [
        {
          asks: 'spanning',
          options: polygon.vertices.map((_, edge) => ({
            value: String(edge),
            note: edgeNote(polygon, edge),
          })),
          right: edges.map(({ event }) => String(event.edge)),
          decidedBy: (edge) => edges.find(({ event }) => String(event.edge) === edge)?.step,
        },
        { asks: 'z', options: [], right },
      ],
      because: inOrder(edges, [result]),
      things: [polygonThing(polygon.id), ...edges.map(({ event }) => edgeThing(event.edge))],
    };
  },
};

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
            note: comparedNote(z, against),
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

/** Which pixels of a row does an outline cover? */
export const fill: Asker<'fill'> = {
  isOf: (method) => method !== 'warnock-simplest',
  from: 'signs',
  at: ['call'],
  ask(trace, step) {
    if (eventAt(trace, step, 'call')?.of !== 'FillPolygon') return null;
    const result = nextOf(trace, step, 'draw', 'pop');
    const { area, byId } = trace.header.scene;
    if (result === null) return null;
    const { polygon } = result.event;
    const outline =
      eventAt(trace, step - 1, 'clip_result')?.vertices ?? byId.get(polygon)?.vertices ?? [];
    const rows = stepsOf(trace, step, result.step, 'row');
    const middle = rows[Math.floor(rows.length / 2)];
    if (middle === undefined || middle.event.exact !== undefined) return null;
    const { row, first, end } = middle.event;
    // The pixels around the left end of the row.
    const from = Math.max(area.x, Math.min(first - 2, area.x + area.width - mostOptions));
    const columns = Array.from(
      { length: Math.min(mostOptions, area.x + area.width - from) },
      (_, i) => from + i,
    );
    if (columns.length < 3) return null;
    return {
      kind: 'fill',
      step,
      until: middle.step,
      about: { polygon, row, outline: outline.map(([x, y]) => [x, y]) },
      parts: [
        {
          asks: 'covered',
          options: columns.map((x) => ({
            value: String(x),
            places: [box('pointed', [x, row, 1, 1])],
          })),
          right: columns.filter((x) => first <= x && x < end).map(String),
        },
      ],
      because: [middle.step],
      things: columns.slice(0, 1).map((x) => pixelThing([x, row])),
    };
  },
};

/** The current window and its polygons. */
export function facts({ after, texts: page, language, header: { method } }: View): readonly Fact[] {
  const { window, apl, joined, way } = after.warnock ?? {};
  if (!window || !apl || !joined || !way) return [];
  const { length } = apl.entries;
  const listed = apl.entries
    .slice(0, mostOptions)
    .map(([id, surrounds]) => (surrounds ? `${id} (${page.surrounds})` : id));
  const others = length > mostOptions ? [page.more(length - mostOptions)] : [];
  return [
    [page.window, texts[language].numbers.windowText(window)],
    [page.apl, [...listed, ...others].join(', ')],
    ...(hasThreeLists(method) ? listFacts(way.length, joined, language) : []),
  ];
}

/** The level of a window, and the two lists besides the third. */
function listFacts(level: number, joined: Warnock['joined'], language: Language): readonly Fact[] {
  const { panel } = texts[language].family;
  const said = (list: Joined): string =>
    list.map((each) => `${each.polygon} (${panel.sinceLevel(each.level)})`).join(', ') || '∅';
  return [
    [panel.level, String(level)],
    [panel.surrounding, said(joined.surrounding)],
    [panel.outside, said(joined.outside)],
  ];
}

export const polygonsAsked = ({ after }: View, named: string | null): readonly string[] =>
  named === null ? (after.warnock?.apl?.entries ?? []).map(([id]) => id) : [named];
