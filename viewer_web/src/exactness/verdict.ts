import type { Trace } from '../replay/trace.js';
import { kinds } from '../trace/events.js';
import type { Deciding, Decision, Event } from '../trace/events.js';
import type { Answer, N, Operands } from '../trace/values.js';

/**
 * A number that a decision used: the one whose sign it took, or one of the two it compared. The name is that of the
 * listing.
 */
type Number = readonly [name: string, value: N];

/** A decision of a step: its numbers, its answer, and the right answer. */
export interface Verdict {
  readonly of: Decision;
  readonly numbers: readonly Number[];
  readonly taken: Answer;
  /** Null if there is no right answer; undefined if the run was not checked. */
  readonly exact: Answer | null | undefined;
  /** The stage that decided, in a run that records it. */
  readonly by: Stage | undefined;
  /** The operands for repeating the decision; undefined if the run was not checked. */
  readonly operands: Operands | undefined;
  /** The cause of a wrong decision. */
  readonly cause: Event<'disagree'>['cause'] | undefined;
}
export type Stage = NonNullable<Event<'orient'>['by']>;

type Decided = Pick<Verdict, 'numbers' | 'taken'>;

const decided: { readonly [K in Deciding]: (event: Event<K>, before: Event | null) => Decided } = {
  orient: ({ value, sign }) => ({ numbers: [['f', value]], taken: sign }),
  clip_sign: ({ value, sign }) => ({ numbers: [['f', value]], taken: sign }),
  compare: ({ z, against, nearer }) => ({
    numbers: [
      ['z', z],
      ['z₀', against],
    ],
    taken: nearer,
  }),
  box: ({ box, outside }) => ({
    numbers: [
      ['x₁', box[0]],
      ['y₁', box[1]],
      ['x₂', box[2]],
      ['y₂', box[3]],
    ],
    taken: outside,
  }),
  insider: ({ inside }) => ({ numbers: [], taken: inside }),
  row: ({ left, right, first, end }) => ({
    numbers: [
      ['x₁', left],
      ['x₂', right],
    ],
    taken: [first, end],
  }),
  columns: ({ first, end }) => ({ numbers: [], taken: [first, end] }),
  pixel: ({ z, stored, shown }) => ({
    numbers: [
      ['z', z],
      ['Z', stored],
    ],
    taken: shown,
  }),
  visibility: ({ flag }, before) => ({
    numbers: before?.e === 'height' ? heights(before) : [],
    taken: flag,
  }),
  behind: ({ z, clipZ, order }) => depths(z, clipZ, order),
  order: ({ z, otherZ, order }) => depths(z, otherZ, order),
};

/** The depths of two polygons at a point, and the order of the first relative to the second. */
const depths = (z: N, other: N, order: number): Decided => ({
  numbers: [
    ['z', z],
    ['z′', other],
  ],
  taken: order,
});

/** The heights of the curve, and of the horizons that exist. */
function heights({ y, upper, lower }: Event<'height'>): readonly Number[] {
  return [
    ['y', y],
    ...(upper === undefined ? [] : [['upper', upper] as const]),
    ...(lower === undefined ? [] : [['lower', lower] as const]),
  ];
}

const isDeciding = (event: Event): event is Event<Deciding> => kinds[event.e].decides !== undefined;

/**
 * Null if the step decides nothing, or makes a right decision without an event of its own. A wrong decision and the
 * following step that reports it have the same verdict.
 */
export function verdictOf({ timeline }: Trace, step: number): Verdict | null {
  const event = timeline.event(step);
  const ownAt = (at: number): Verdict | null =>
    ownVerdict(timeline.event(at), timeline.event(at - 1));
  if (event?.e === 'disagree') return judged(ownAt(step - 1), event);
  const own = ownAt(step);
  const next = timeline.event(step + 1);
  return next?.e === 'disagree' ? judged(own, next) : own;
}

function ownVerdict(event: Event | null, before: Event | null): Verdict | null {
  if (event === null || !isDeciding(event)) return null;
  const { exact, by, operands } = event;
  const how = decided[event.e] as (event: Event, before: Event | null) => Decided;
  return {
    of: kinds[event.e].decides,
    ...how(event, before),
    exact,
    by,
    operands,
    cause: undefined,
  };
}

/** A step may decide more than one thing, or something without an event of its own. The wrong decision takes precedence. */
function judged(
  own: Verdict | null,
  { of, taken, exact, cause, operands }: Event<'disagree'>,
): Verdict {
  return { numbers: own?.numbers ?? [], by: undefined, of, taken, exact, cause, operands };
}

/** Whether an answer is known to be wrong. */
export function isWrong({ taken, exact }: Verdict): boolean {
  return exact !== null && exact !== undefined && String(taken) !== String(exact);
}
