import type { Columns } from '../replay/columns.js';
import type { CurveEvents, Event } from '../trace/events.js';
import type { Curve } from '../trace/header.js';
import { Refusal } from '../trace/refusal.js';
import type { Sample } from '../trace/values.js';
import type { Flag, Segment } from './events.js';

declare module '../replay/model.js' {
  interface Held {
    readonly horizon?: FloatingHorizon;
  }
}

declare module '../language/words.js' {
  interface Known {
    readonly horizon?: Pick<FloatingHorizon, 'curve' | 'place' | 'told'>;
  }
}

/** A column and the result of Visibility for it. */
export type Looked = readonly [x: number, flag: Flag];

/** The part of the current curve that was examined last. */
interface Place {
  readonly segment: Segment | null;
  /** x and Pflag of the listing. */
  readonly previous: Looked | null;
  /** x' and Tflag. */
  readonly current: Looked | null;
}

/** The state of the floating horizon, except for the values over each column. */
export interface FloatingHorizon {
  /** The index of the current curve in the scene. */
  readonly curve: number | null;
  readonly place: Place;
  /** The height that Visibility examined last, if the trace contains it. */
  readonly told: CurveEvents['height'] | null;
  /** The points that the side edges have reached. */
  readonly edges: { readonly left: Sample | null; readonly right: Sample | null };
}

const nowhere: Place = { segment: null, previous: null, current: null };

export const emptyFloatingHorizon: FloatingHorizon = {
  curve: null,
  place: nowhere,
  told: null,
  edges: { left: null, right: null },
};

type Name = keyof CurveEvents;
type Handler<K extends Name> = (
  event: Event<K>,
  now: FloatingHorizon,
  columns: Columns,
) => Partial<FloatingHorizon>;

const unchanged: Partial<FloatingHorizon> = {};
const nothing = (): Partial<FloatingHorizon> => unchanged;

/** Whether the curve has samples on these columns and none between. */
function isOf([first, last]: Segment, curve: Curve): boolean {
  const from = curve.findIndex(([x]) => x === first);
  return from >= 0 && curve[from + 1]?.[0] === last;
}

function expectOf(segment: Segment, { curve }: FloatingHorizon, { scene }: Columns): void {
  const samples = scene.curves?.[curve ?? -1] ?? [];
  if (!isOf(segment, samples)) throw new Refusal('segment', 'notOfCurve', segment.join(', '));
}

/** The place after Visibility has examined one more column. */
export function placeAfter(
  { at, segment, x, flag }: CurveEvents['visibility'],
  { previous, current }: Place,
): Place {
  return at === 'FH4'
    ? { segment, previous: [x, flag], current }
    : { segment, previous: current ?? previous, current: [x, flag] };
}

const handlers: { readonly [K in Name]: Handler<K> } = {
  horizons: ({ upper = null, lower = null }, _now, columns) => {
    columns.begin(upper, lower);
    return unchanged;
  },
  curve: ({ curve }, _now, columns) => {
    if (curve >= (columns.scene.curves?.length ?? 0)) {
      throw new Refusal('curve', 'noSuchCurve', String(curve));
    }
    columns.forget();
    return { curve, place: nowhere, told: null };
  },
  side_edge: ({ at, sample }, { edges }) => ({
    edges: at === 'FH3' ? { ...edges, left: sample } : { ...edges, right: sample },
  }),
  visibility: (event, { place }, columns) => {
    columns.look(event.x, event.flag);
    if (event.at === 'FH4') columns.keep();
    return { place: placeAfter(event, place) };
  },
  intersection: nothing,
  draw_line: ({ segment }, now, columns) => {
    expectOf(segment, now, columns);
    return { place: { ...now.place, segment } };
  },
  horizon: ({ upper, lower }, _now, columns) => {
    for (const [x, y] of upper) columns.raise(x, y);
    for (const [x, y] of lower) columns.lower(x, y);
    return unchanged;
  },
  height: (event) => ({ told: event }),
  raise: ({ x, y }, _now, columns) => {
    columns.raise(x, y);
    return unchanged;
  },
  lower: ({ x, y }, _now, columns) => {
    columns.lower(x, y);
    return unchanged;
  },
  step: nothing,
};

export function afterCurves(event: Event, now: FloatingHorizon, columns: Columns): FloatingHorizon {
  const handle = (handlers as Readonly<Partial<Record<string, Handler<Name>>>>)[event.e];
  const change = handle?.(event as Event<Name>, now, columns) ?? unchanged;
  return change === unchanged ? now : { ...now, ...change };
}
