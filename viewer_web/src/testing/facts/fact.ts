import type { Language } from '../../language/language.js';
import type { Edition } from '../../trace/editions.js';
import type { Event, EventName } from '../../trace/events.js';
import type { Box, N } from '../../trace/values.js';

/** A state as the program writes it: the fields that the facts below need. */
export interface ProgramState {
  readonly warnock?: {
    readonly window: Box | null;
    readonly apl: readonly (readonly [string, boolean])[] | null;
    readonly surrounding?: readonly (readonly [string, number])[];
  } | null;
  readonly zbuffer?: { readonly polygon: string | null } | null;
  readonly weilerAtherton?: {
    readonly list: { readonly pieces: readonly Piece[] } | null;
  };
}
type Piece = readonly [string, readonly (readonly (readonly N[])[])[], boolean];

/** The data around a step, from the events so far, as written, and the program's state. */
export interface Moment {
  readonly after: ProgramState;
  readonly detail: string;
  readonly edition: Edition;
  readonly scene: {
    readonly background: string;
    readonly polygons?: readonly { readonly id: string; readonly color: string }[];
  };
  /** The number of divisions of the area to get the current window. */
  readonly level: number;
  /** The polygon that surrounds the current window and hides all others so far, before the step and after it. */
  readonly covered: readonly [before: string | null, after: string | null];
  /** The polygon that PointColor has found in the current window. */
  readonly nearest: string | null;
  /** The count of the outline's edges, including that of the step. */
  readonly counted: number;
  /** The last height of the current curve. */
  readonly height: Event<'height'> | null;
  /** The number of pieces of the current list examined so far. */
  readonly looked: number;
}

/** A statement of a sentence: polygons, numbers, and answers in words. Languages may order them differently. */
export interface Fact {
  readonly ids?: readonly string[];
  readonly numbers?: readonly N[];
  /** One pattern for all languages, or one for each. A pattern after a minus must not occur. */
  readonly says?: readonly Says[];
}
export type Says = Readonly<Record<Language, RegExp>>;

export type Facts<K extends EventName> = {
  readonly [P in K]: (event: Event<P>, moment: Moment) => Fact;
};

export const said = (en: RegExp, ru: RegExp): Says => ({ en, ru });
/** One of two answers. */
export const answered = (is: boolean, yes: Says, no: Says): readonly Says[] => [is ? yes : no];

export const none: Fact = {};
export const of = (polygon: string, ...numbers: readonly N[]): Fact => ({
  ids: [polygon],
  numbers,
});
export const only = (...numbers: readonly N[]): Fact => ({ numbers });

const mostIds = 6;
export const listed = (ids: readonly string[]): readonly string[] => ids.slice(0, mostIds);

export const total = (runs: readonly (readonly number[])[]): number =>
  runs.reduce((sum, run) => sum + (run.at(-1) ?? 0) - (run.at(-2) ?? 0), 0);
