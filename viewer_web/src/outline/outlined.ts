import type { Language } from '../language/language.js';
import type { Event, EventName, Procedure } from '../trace/events.js';
import type { Header } from '../trace/header.js';

/** What a node is: an item of the algorithm, a part of one, or a procedure. */
export type Kind = 'hand' | 'part' | Procedure;

/** A node, to be told in a few words. */
export interface Told {
  readonly header: Header;
  readonly kind: Kind;
  /** Its steps, but those of further nodes of the current item left out. */
  readonly first: number;
  readonly last: number;
  /** Where the current item began. */
  readonly inHandFrom: number;
  /** See `Stretches`. */
  readonly part: number;
  event(step: number): Event | null;
  /** The steps among its own, or from another step on, whose events have this name. */
  stepsOf(name: EventName, from?: number): readonly number[];
}

/** What the outline of an algorithm's runs has, beside the items that `begins` names and the procedures, each from its call to its result. */
export interface Outlined {
  /** The events at which a part of the current item begins; it ends where the next one does. */
  readonly parts: readonly EventName[];
  /** The number that a part is known by, of the event at which it begins. */
  numberOf?(event: Event): number | null;
  /** The current item, or a part of it, in a few words; of a procedure null, if its name and its result will do. */
  say(told: Told, language: Language): string | null;
}
