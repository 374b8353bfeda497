import { polygonThing } from '../algorithm/pointed.js';
import type { View } from '../algorithm/view.js';
import { texts } from '../i18n/index.js';
import { point, relationBy, toNumber } from '../language/words.js';
import { point as dot } from '../picture/mark.js';
import { eventAt, inOrder, nextOf, stepsOf } from '../predict/ahead.js';
import type { Step } from '../predict/ahead.js';
import {
  cellsOf,
  depthOptions,
  mostOptions,
  optionsOf,
  pointOptions,
  relationOptions,
} from '../predict/asker.js';
import type { Asker } from '../predict/asker.js';
import type { Fact } from '../predict/facts.js';
import type { Option, Part } from '../predict/question.js';
import { becomes } from '../predict/question.js';
import type { Trace } from '../replay/trace.js';
import type { WeilerAtherton } from '../replay/values.js';
import type { Event } from '../trace/events.js';
import type { Piece } from '../trace/values.js';
import { boundsOf } from './geometry.js';
import { emptyWeilerAtherton } from './state.js';

/** The polygons of these pieces, each once. */
const ownersOf = (pieces: readonly Piece[]): readonly string[] => [
  ...new Set(pieces.map(([id]) => id)),
];

/** A piece of the current list that is clipped by the first one. */
interface Clipping {
  readonly clip: Piece;
  /** The outline of the piece, split at its intersections with the clip polygon. */
  readonly outline: readonly Event<'edge_piece'>[];
  readonly result: Step<'clipped'>;
}

/** The clipping that begins at a step; null if none does. */
function clippingAt(trace: Trace, step: number): Clipping | null {
  const call = eventAt(trace, step, 'call');
  if (call?.of !== 'RegionClip' || call.at !== 'WA5') return null;
  const result = nextOf(trace, step, 'clipped', 'pop_list');
  const clip = trace.timeline.seek(step).values.weilerAtherton?.currentList?.pieces[0];
  if (result === null || clip === undefined) return null;
  const outline = stepsOf(trace, step, result.step, 'edge_piece').map(({ event }) => event);
  return { clip, outline, result };
}

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

/** The greatest offered difference between the numbers of pieces and of polygons. */
const mostMore = 4;

/** Which polygons pierce each other, and how many pieces result? */
export const piercing: Asker<'piercing'> = {
  from: 'polygons',
  at: ['call'],
  ask(trace, step) {
    if (eventAt(trace, step, 'call')?.of !== 'SplitPiercing') return null;
    const result = nextOf(trace, step, 'facets');
    if (result === null) return null;
    const until = result.step;
    const looked = stepsOf(trace, step, until, 'clipped');
    const ids = ownersOf(trace.timeline.seek(step).values.weilerAtherton?.facets ?? []);
    const { length } = result.event.pieces;
    if (looked.length === 0 || ids.length > mostOptions || length > ids.length + mostMore) {
      return null;
    }
    const pierced = stepsOf(trace, step, until, 'pierce');
    const split = stepsOf(trace, step, until, 'split');
    const counts = Array.from({ length: mostMore + 1 }, (_, more) => String(ids.length + more));
    return {
      kind: 'piercing',
      step,
      until,
      about: { polygons: ids },
      parts: [
        {
          asks: 'pierced',
          options: optionsOf(ids),
          right: [...new Set(split.map(({ event }) => event.polygon))],
        },
        { asks: 'pieces', options: optionsOf(counts), right: [String(length)] },
      ],
      because: inOrder(looked, pierced, split, [result]),
      things: ids.map(polygonThing),
    };
  },
};

/** More outlines than most parts have. */
const counts = ['0', '1', '2', '3', '4'];

/** Asks for the number of outlines of a part outside, preferably one with several, where mistakes are likely. */
function outlinesOf(
  others: readonly Piece[],
  clipped: readonly Step<'clipped'>[],
  step: number,
): Part | null {
  const piecesOf = (polygon: string): number => others.filter(([id]) => id === polygon).length;
  const asked = clipped.filter(
    ({ event }) => event.outside.length < counts.length && piecesOf(event.polygon) === 1,
  );
  const several = asked.find(({ event }) => event.outside.length > 1);
  const one = (several ?? asked[step % asked.length])?.event;
  if (one === undefined) return null;
  return {
    asks: 'outlines',
    options: optionsOf(counts),
    right: [String(one.outside.length)],
    given: [{ value: one.polygon, of: 'polygon' }],
  };
}

/** Which parts of a list are inside the clip polygon, and which are outside? */
export const parted: Asker<'parted'> = {
  from: 'polygons',
  at: ['pop_list'],
  ask(trace, step) {
    const end = nextOf(trace, step, 'nearer_ones', 'pop_list');
    const [clip, ...others] =
      trace.timeline.seek(step).values.weilerAtherton?.currentList?.pieces ?? [];
    if (end === null || clip === undefined) return null;
    const clipped = stepsOf(trace, step, end.step, 'clipped');
    const beside = stepsOf(trace, step, end.step, 'beside');
    const because = inOrder(clipped, beside);
    const until = because.at(-1);
    const ids = ownersOf(others);
    const outlines = outlinesOf(others, clipped, step);
    if (until === undefined || clipped.length === 0 || ids.length > mostOptions) return null;
    if (outlines === null && ids.length < 2) return null;
    const polygonsOf = (steps: readonly Step<'clipped' | 'beside'>[]): readonly string[] => [
      ...new Set(steps.map(({ event }) => event.polygon)),
    ];
    const within = clipped.filter(({ event }) => event.inside.length > 0);
    const beyond = clipped.filter(({ event }) => event.outside.length > 0);
    return {
      kind: 'parted',
      step,
      until,
      about: { clip: clip[0], pieces: others.length + 1 },
      parts: [
        { asks: 'within', options: optionsOf(ids), right: polygonsOf(within) },
        { asks: 'beyond', options: optionsOf(ids), right: polygonsOf([...beside, ...beyond]) },
        ...(outlines === null ? [] : [outlines]),
      ],
      because,
      things: [clip[0], ...ids].map(polygonThing),
    };
  },
};

/** The part that asks for some of the points. */
function pointsPart(
  asks: 'enters' | 'leaves',
  options: readonly Option[],
  steps: readonly Step<'entering' | 'leaving'>[],
): Part {
  return {
    asks,
    options,
    right: steps.map(({ event }) => point(event.point)),
    decidedBy: (value) => steps.find(({ event }) => point(event.point) === value)?.step,
  };
}

/** Where does the outline enter the clip polygon, and where does it leave it? */
export const entering: Asker<'entering'> = {
  from: 'signs',
  at: ['call'],
  ask(trace, step) {
    const clipping = clippingAt(trace, step);
    if (clipping === null) return null;
    const { clip, outline, result } = clipping;
    const options = pointOptions(outline.map(({ from }) => from));
    const points = new Set(options.map(({ value }) => value));
    if (options.length > mostOptions || points.size < options.length) return null;
    const until = result.step;
    const enters = stepsOf(trace, step, until, 'entering');
    const leaves = stepsOf(trace, step, until, 'leaving');
    const { polygon } = result.event;
    return {
      kind: 'entering',
      step,
      until,
      about: { polygon, clip: clip[0] },
      parts: [pointsPart('enters', options, enters), pointsPart('leaves', options, leaves)],
      because: inOrder(stepsOf(trace, step, until, 'edge_piece'), enters, leaves, [result]),
      things: [polygon, clip[0]].map(polygonThing),
    };
  },
};

/** More points would be confusing. */
const mostPoints = 12;

/** The other points of a loop in order, starting after this one; null if it does not occur exactly once on one loop. */
function afterStart(
  loops: readonly (readonly string[])[],
  start: string,
): readonly string[] | null {
  const [loop = [], ...others] = loops.filter((each) => each.includes(start));
  const at = loop.indexOf(start);
  if (at < 0 || others.length > 0 || loop.lastIndexOf(start) !== at) return null;
  return [...loop.slice(at + 1), ...loop.slice(0, at)];
}

/** In which order does the walk go around the part inside the clip polygon? */
export const walk: Asker<'walk'> = {
  from: 'signs',
  at: ['call'],
  ask(trace, step) {
    const clipping = clippingAt(trace, step);
    if (clipping === null) return null;
    const { clip, outline, result } = clipping;
    const until = result.step;
    const enters = stepsOf(trace, step, until, 'entering');
    const leaves = stepsOf(trace, step, until, 'leaving');
    const [start] = enters.map(({ event }) => point(event.point));
    const places = new Map(
      [...outline.map(({ from }) => from), ...clip[1].flat()].map((at) => [point(at), at]),
    );
    const points = [...places.keys()];
    const { polygon, inside } = result.event;
    if (start === undefined || points.length > mostPoints) return null;
    const way = afterStart(
      inside.map((loop) => loop.map(point)),
      start,
    );
    const numberOf = (at: string): string => String(points.indexOf(at) + 1);
    if (way?.every((at) => points.includes(at)) !== true) return null;
    return {
      kind: 'walk',
      step,
      until,
      about: { polygon, clip: clip[0], from: numberOf(start) },
      parts: [
        {
          asks: 'walked',
          options: [...places].map(([name, at]) => ({
            value: numberOf(name),
            places: [dot('pointed', at)],
          })),
          right: way.map(numberOf),
          given: [...places].map(([name, at]) => ({
            value: numberOf(name),
            of: 'vertex',
            note: ({ numbers: write }) => write.point(at),
          })),
        },
      ],
      because: inOrder(enters, leaves, [result]),
      things: [polygon, clip[0]].map(polygonThing),
    };
  },
};

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
    const { currentList = null } = trace.timeline.seek(step).values.weilerAtherton ?? {};
    const clip = currentList?.pieces[0];
    if (result === null || currentList === null || clip === undefined) return null;
    const parts = currentList.inside.filter(([, , ground]) => !ground);
    const ids = new Set(parts.map(([id]) => id));
    const areNumbers = parts.every(([, region]) => region.flat(2).every(isNumber));
    if (parts.length === 0 || ids.size < parts.length || !areNumbers) return null;
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

const isNumber = (value: Parameters<typeof toNumber>[0]): boolean =>
  Number.isFinite(toNumber(value));

/** Which list is popped from the stack next, and which polygon clips then? A single list would be obvious. */
export const stack: Asker<'stack'> = {
  from: 'polygons',
  at: ['nearer_ones'],
  ask(trace, step) {
    const nearer = eventAt(trace, step, 'nearer_ones');
    const pop = nextOf(trace, step, 'pop_list');
    const { lists = [], currentList = null } =
      trace.timeline.seek(step).values.weilerAtherton ?? {};
    const clip = currentList?.pieces[0];
    if (nearer === null || pop === null || currentList === null || clip === undefined) return null;
    const ids = ownersOf([...currentList.inside, clip, ...lists.flat()]);
    if (nearer.polygons.length === 0 && lists.length < 2) return null;
    if (ids.length < 2 || ids.length > mostOptions) return null;
    const pushed = stepsOf(trace, step, pop.step, 'push_list');
    const next = pushed.at(-1)?.event.pieces ?? lists.at(-1) ?? [];
    const shown = stepsOf(trace, step, pop.step, 'show');
    return {
      kind: 'stack',
      step,
      until: pop.step,
      about: { clip: clip[0], nearer: [...new Set(nearer.polygons)] },
      parts: [
        { asks: 'clips', options: optionsOf(ids), right: [pop.event.clip] },
        { asks: 'listed', options: optionsOf(ids), right: ownersOf(next) },
      ],
      because: inOrder(shown, pushed, [pop]),
      things: [polygonThing(clip[0])],
    };
  },
};

/** Which of two polygons is the nearer at a pixel that belongs to regions of both? */
export const painted: Asker<'painted'> = {
  from: 'signs',
  at: ['row', 'order'],
  ask(trace, step) {
    const next = eventAt(trace, step + 1, 'order');
    if (next === null) return null;
    const { polygon, other, point, z, otherZ, order } = next;
    const right = cellsOf([z, otherZ], trace.header);
    if (right === null) return null;
    return {
      kind: 'painted',
      step,
      until: step + 1,
      about: { polygon, other, point },
      parts: [
        { asks: 'bothDepths', options: [], right },
        { asks: 'nearerThere', options: relationOptions, right: [relationBy[order]] },
      ],
      because: [step + 1],
      things: [polygon, other].map(polygonThing),
    };
  },
};

/** The current list, or before the first one the pieces to sort. */
const piecesOf = ({ currentList, facets }: WeilerAtherton): readonly Piece[] =>
  currentList?.pieces ?? facets;

/** The pieces with their outlines in walking order, and the polygons of the other lists from the top of the stack. */
export function facts({ after, texts: page, language }: View): readonly Fact[] {
  const now = after.weilerAtherton;
  if (now === undefined) return [];
  const { regions: say, numbers } = texts[language];
  const pieces = piecesOf(now);
  const listed = pieces.slice(0, mostOptions).map(([id, region, ground]) => {
    const loops = region.map((loop) => loop.map(numbers.point).join(' ')).join(' / ');
    return `${id}${ground ? ` (${say.ground})` : ''}: ${loops}`;
  });
  const others = pieces.length > mostOptions ? [page.more(pieces.length - mostOptions)] : [];
  const lists = [...now.lists].reverse().map((list) => list.map(([id]) => id).join(', '));
  return [
    [now.currentList === null ? say.pieces : say.list, [...listed, ...others].join('; ')],
    [say.lists, lists.join('; ') || '∅'],
  ];
}

export const polygonsAsked = ({ after }: View): readonly string[] =>
  ownersOf(piecesOf(after.weilerAtherton ?? emptyWeilerAtherton));
