import type { Language } from '../language/language.js';
import type { Event, EventName, Procedure } from '../trace/events.js';
import type { Header } from '../trace/header.js';

/** The kind of a node: an item of the algorithm, a part of one, or a procedure. */
export type Kind = 'item' | 'part' | Procedure;

/** The data of a node for its text. */
export interface NodeData {
  readonly header: Header;
  readonly kind: Kind;
  /** Its steps, without those of nested items. */
  readonly first: number;
  readonly last: number;
  /** The step at which the current item began. */
  readonly itemFrom: number;
  /** See `Stretches`. */
  readonly part: number;
  event(step: number): Event | null;
  /** The note of a step's event, as beside the listing. */
  note(step: number, language: Language): string;
  /** The steps with this event name, among its own or from another step on. */
  stepsOf(name: EventName, from?: number): readonly number[];
}

/**
 * The additions of an algorithm's outline to the items and the procedures, each from its call to its result.
 */
export interface Outlined {
  /** The events at which a part of the current item begins. It ends where the next one begins. */
  readonly parts: readonly EventName[];
  /** The number that identifies a part, from its first event. */
  numberOf?(event: Event): number | null;
  /** The text of an item or a part of one; for a procedure null, if its name and result suffice. */
  say(node: NodeData, language: Language): string | null;
}
