import type { Columns } from '../replay/columns.js';
import { Effects, noneOfCommon, nothing } from '../replay/effects.js';
import type { FloatingHorizonEvents } from '../trace/events.js';
import type { Curve } from '../trace/header.js';
import { Refusal } from '../trace/refusal.js';
import type { Sample } from '../trace/values.js';
import type { Flag, Segment } from './events.js';

declare module '../replay/model.js' {
  interface Held {
    readonly floatingHorizon?: FloatingHorizon;
  }
}

declare module '../language/words.js' {
  interface Known {
    readonly floatingHorizon?: Pick<FloatingHorizon, 'curve' | 'place' | 'told'>;
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
  readonly told: FloatingHorizonEvents['height'] | null;
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
  { at, segment, x, flag }: FloatingHorizonEvents['visibility'],
  { previous, current }: Place,
): Place {
  return at === 'FH4'
    ? { segment, previous: [x, flag], current }
    : { segment, previous: current ?? previous, current: [x, flag] };
}

export const effects = new Effects<keyof FloatingHorizonEvents, FloatingHorizon, Columns>({
  ...noneOfCommon,
  horizons: {
    sets: ['horizons'],
    does: ({ upper = null, lower = null }, _now, columns) => {
      columns.begin(upper, lower);
      return undefined;
    },
  },
  curve: {
    sets: ['curve', 'place', 'told', 'flags', 'before'],
    reads: ['horizons'],
    needs: [],
    does: ({ curve }, _now, columns) => {
      if (curve >= (columns.scene.curves?.length ?? 0)) {
        throw new Refusal('curve', 'noSuchCurve', String(curve));
      }
      columns.forget();
      return { curve, place: nowhere, told: null };
    },
  },
  side_edge: {
    changes: ['edges'],
    does: ({ at, sample }, { edges }) => ({
      edges: at === 'FH3' ? { ...edges, left: sample } : { ...edges, right: sample },
    }),
  },
  visibility: {
    changes: ['place', 'flags', 'before'],
    reads: ['horizons'],
    needs: [],
    does: (event, { place }, columns) => {
      columns.look(event.x, event.flag);
      if (event.at === 'FH4') columns.keep();
      return { place: placeAfter(event, place) };
    },
  },
  intersection: nothing,
  draw_line: {
    changes: ['place'],
    reads: ['curve'],
    needs: ['curve'],
    does: ({ segment }, now, columns) => {
      expectOf(segment, now, columns);
      return { place: { ...now.place, segment } };
    },
  },
  horizon: {
    changes: ['horizons'],
    needs: [],
    does: ({ upper, lower }, _now, columns) => {
      for (const [x, y] of upper) columns.raise(x, y);
      for (const [x, y] of lower) columns.lower(x, y);
      return undefined;
    },
  },
  height: { sets: ['told'], does: (event) => ({ told: event }) },
  raise: {
    changes: ['horizons'],
    needs: [],
    does: ({ x, y }, _now, columns) => {
      columns.raise(x, y);
      return undefined;
    },
  },
  lower: {
    changes: ['horizons'],
    needs: [],
    does: ({ x, y }, _now, columns) => {
      columns.lower(x, y);
      return undefined;
    },
  },
  step: nothing,
});
