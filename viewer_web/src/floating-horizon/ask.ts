import { columnThing, curveThing } from '../algorithm/pointed.js';
import { path } from '../picture/mark.js';
import type { Mark } from '../picture/mark.js';
import { eventAt, inOrder, nextOf, stepsOf } from '../predict/ahead.js';
import type { Step } from '../predict/ahead.js';
import type { Asker } from '../predict/asker.js';
import { between } from '../predict/question.js';
import type { Option } from '../predict/question.js';
import type { Trace } from '../replay/trace.js';
import { hasDefect } from '../trace/editions.js';
import type { Event } from '../trace/events.js';
import type { Area } from '../trace/header.js';
import type { N } from '../trace/values.js';
import { sideBeside } from './state.js';

/** The most columns in one question. */
const mostColumns = 4;
/** The number of steps to search back for the heights of the curve. */
const farthest = 200;

type Height = Event<'height'>;

/** A line over a column, from the top of the area to its bottom. */
const over = (x: number, { y, height }: Area): readonly Mark[] => [
  path('pointed', [
    [x, y],
    [x, y + height],
  ]),
];

/** A column with the values over it, which help to answer; without y, that is to be computed. */
const columnOption = (
  area: Area,
  x: number,
  y: N | null,
  upper?: N | null,
  lower?: N | null,
): Option => ({
  value: String(x),
  places: over(x, area),
  note: ({ numbers, curves }) => {
    const shown = (value: N | null | undefined): string =>
      value === null || value === undefined ? '—' : numbers.short(value);
    const height = y === null ? '' : `y = ${numbers.short(y)}; `;
    return `${height}${curves.upper} ${shown(upper)}; ${curves.lower} ${shown(lower)}`;
  },
});

const hasHorizon = ({ upper, lower }: Height): boolean =>
  upper !== undefined && lower !== undefined;

/** The last heights of the curve before a step, by their columns. */
function heightsBefore({ timeline }: Trace, step: number): ReadonlyMap<number, Height> {
  const found = new Map<number, Height>();
  for (let at = step; at > Math.max(0, step - farthest) && found.size < 2; at--) {
    const event = timeline.event(at);
    if (event?.e === 'curve') break;
    if (event?.e === 'height' && !found.has(event.x)) found.set(event.x, event);
  }
  return found;
}

const curveOf = (trace: Trace, step: number): number =>
  trace.timeline.seek(step).values.floatingHorizon?.curve ?? 0;

type Which = 'upper' | 'lower';

/** The height of a horizon over a column at a step; null if there is none. */
function horizonAt({ timeline, header }: Trace, step: number) {
  const horizons = timeline.valuesAt(step).floatingHorizon?.horizons;
  return (which: Which, x: number): N | null => horizons?.[which][x - header.scene.area.x] ?? null;
}

/** The parts that ask over which of some columns each horizon moves, and the steps that move them. */
function moved(trace: Trace, step: number, until: number, options: readonly Option[]) {
  const raised = stepsOf(trace, step, until, 'raise');
  const lowered = stepsOf(trace, step, until, 'lower');
  const places = (of: readonly Step<'raise' | 'lower'>[]): readonly string[] =>
    of.map(({ event }) => String(event.x));
  return {
    parts: [
      { asks: 'raised', options, right: places(raised) },
      { asks: 'lowered', options, right: places(lowered) },
    ] as const,
    steps: [...raised, ...lowered],
  };
}

/** The last sample on a side of the surface before a step. */
function sideBefore({ timeline }: Trace, step: number, at: Event<'side_edge'>['at']) {
  for (let back = step - 1; back > 0; back--) {
    const event = timeline.event(back);
    if (event?.e === 'side_edge' && event.at === at) return event.sample;
  }
  return null;
}

/** Over which columns does a side edge move the horizons? */
export const sideEdge: Asker<'sideEdge'> = {
  from: 'signs',
  at: ['call'],
  ask(trace, step) {
    if (eventAt(trace, step, 'call')?.at !== 'SE2') return null;
    const result = nextOf(trace, step, 'horizon', 'curve');
    const end = nextOf(trace, step, 'side_edge', 'curve');
    const from = end === null ? null : sideBefore(trace, step, end.event.at);
    if (result === null || end === null || from === null) return null;
    const { first, last } = result.event;
    const count = last - first + 1;
    if (count < 2 || count > mostColumns) return null;
    const now = horizonAt(trace, step);
    const options = Array.from({ length: count }, (_, i) => first + i).map((x) =>
      columnOption(trace.header.scene.area, x, null, now('upper', x), now('lower', x)),
    );
    const { parts, steps } = moved(trace, step, result.step, options);
    return {
      kind: 'sideEdge',
      step,
      until: result.step,
      about: { curve: curveOf(trace, step), from, to: end.event.sample },
      parts,
      because: inOrder(steps, [result]),
      things: [columnThing(first)],
    };
  },
};

/** How does the curve lie relative to the horizons over the next columns? */
export const flags: Asker<'flags'> = {
  from: 'signs',
  at: ['visibility'],
  ask(trace, step) {
    const end = nextOf(trace, step, 'curve')?.step ?? trace.timeline.length + 1;
    const steps = stepsOf(trace, step, Math.min(end - 1, step + farthest), 'visibility');
    const next = steps.slice(0, mostColumns);
    const until = next.at(-1)?.step;
    if (until === undefined || next.length < mostColumns) return null;
    const heights = stepsOf(trace, step, until, 'height').map(({ event }) => event);
    const found = new Set(next.map(({ event }) => event.flag));
    if (found.size < 2 || !heights.every(hasHorizon)) return null;
    const options = heights.map(({ x, y, upper, lower }) =>
      columnOption(trace.header.scene.area, x, y, upper, lower),
    );
    const flagged = (...wanted: readonly number[]): readonly string[] =>
      next.filter(({ event }) => wanted.includes(event.flag)).map(({ event }) => String(event.x));
    const decidedBy = (x: string | null): number | undefined =>
      next.find(({ event }) => String(event.x) === x)?.step;
    const curve = curveOf(trace, step);
    return {
      kind: 'flags',
      step,
      until,
      about: { curve },
      parts: [
        { asks: 'above', options, right: flagged(1, 2), decidedBy },
        { asks: 'below', options, right: flagged(-1, 2), decidedBy },
      ],
      because: inOrder(next),
      things: [curveThing(curve)],
    };
  },
};

/** Over which of the two columns do the horizons change? */
export const horizons: Asker<'horizons'> = {
  from: 'signs',
  at: ['call'],
  ask(trace, step) {
    if (eventAt(trace, step, 'call')?.of !== 'Horizon') return null;
    const result = nextOf(trace, step, 'horizon', 'curve');
    if (result === null) return null;
    const { first, last, at } = result.event;
    const heights = heightsBefore(trace, step);
    const known = [heights.get(first), heights.get(last)].filter((each) => each !== undefined);
    if (at === 'SE2' || last !== first + 1 || known.length < 2) return null;
    const now = horizonAt(trace, step);
    const options = known.map(({ x, y }) =>
      columnOption(trace.header.scene.area, x, y, now('upper', x), now('lower', x)),
    );
    if (known.some(({ x }) => now('upper', x) === null)) return null;
    const { parts, steps } = moved(trace, step, result.step, options);
    return {
      kind: 'horizons',
      step,
      until: result.step,
      about: { curve: curveOf(trace, step) },
      parts,
      because: inOrder(steps, [result]),
      things: known.map(({ x }) => columnThing(x)),
    };
  },
};

/** Which horizon does the segment meet, and where? */
export const meeting: Asker<'meeting'> = {
  from: 'signs',
  at: ['call'],
  ask(trace, step) {
    if (eventAt(trace, step, 'call')?.of !== 'Intersection') return null;
    const result = nextOf(trace, step, 'intersection', 'curve');
    const { place, curve } = trace.timeline.seek(step).values.floatingHorizon ?? {};
    const [from, to] = [place?.previous, place?.current];
    const heights = heightsBefore(trace, step);
    if (result === null || !from || to?.[0] !== from[0] + 1) return null;
    const known = [heights.get(from[0]), heights.get(to[0])].filter((each) => each !== undefined);
    if (known.length < 2 || !known.every(hasHorizon)) return null;
    const was = sideBeside(from[1], to[1]);
    const is = sideBeside(to[1], from[1]);
    // A segment that passes both horizons meets both.
    if (was !== 'hidden' && is !== 'hidden') return null;
    const isUpper = (result.event.at === 'FH7' ? was : is) === 'above';
    const isFirstByDefect = hasDefect(trace.header.edition, 'x-h2') && was === 'hidden'; // X-H2
    const { columns } = result.event;
    const { area } = trace.header.scene;
    const spot = columns[0] === columns[1] ? String(columns[0]) : between;
    return {
      kind: 'meeting',
      step,
      until: result.step,
      about: { curve: curve ?? 0 },
      parts: [
        {
          asks: 'meets',
          options: [{ value: 'upper' }, { value: 'lower' }],
          right: [isUpper || isFirstByDefect ? 'upper' : 'lower'],
          given: known.map(({ x, y, upper, lower }) => ({
            ...columnOption(area, x, y, upper, lower),
            of: 'column',
          })),
        },
        {
          asks: 'where',
          options: [
            { value: String(from[0]), places: over(from[0], area) },
            { value: between, places: over(from[0] + 0.5, area) },
            { value: String(to[0]), places: over(to[0], area) },
          ],
          right: [spot],
        },
      ],
      because: inOrder(stepsOf(trace, step, result.step, 'step'), [result]),
      things: known.map(({ x }) => columnThing(x)),
    };
  },
};
