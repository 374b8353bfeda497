import type { Language } from '../../language/language.js';
import type { Edition } from '../../trace/editions.js';
import type { Event, EventName } from '../../trace/events.js';
import type { Box, N } from '../../trace/values.js';

/** A state as the program writes it: what the facts below need of it. */
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

/** What the events so far, as they are written, and the program's state say around a step. */
export interface Moment {
  readonly after: ProgramState;
  readonly detail: string;
  readonly edition: Edition;
  readonly scene: {
    readonly background: string;
    readonly polygons?: readonly { readonly id: string; readonly color: string }[];
  };
  /** How often the area was split to get the current window. */
  readonly level: number;
  /** Of the current window: what surrounds it and hides all so far, before the step and after it. */
  readonly covered: readonly [before: string | null, after: string | null];
  /** What PointColor has found in the current window. */
  readonly nearest: string | null;
  /** What the edges of the outline count, that of the step too. */
  readonly counted: number;
  /** The height that was told last of the current curve. */
  readonly height: Event<'height'> | null;
  /** How many pieces of the current list were looked at. */
  readonly looked: number;
}

/** What a sentence states: polygons, numbers, and answers in words. Those that several languages put in another order are the same. */
export interface Fact {
  readonly ids?: readonly string[];
  readonly numbers?: readonly N[];
  /** One pattern for all languages, or one for each; with a minus before it, it must not be found. */
  readonly says?: readonly Says[];
}
type Says = Readonly<Record<Language, RegExp>>;

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
