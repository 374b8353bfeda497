import { eventNames } from '../trace/events.js';
import type { EventName } from '../trace/events.js';

/**
 * How an event uses the state before it, by the names of the state's fields. The call stack and the drawn lines are handled
 * separately.
 */
export interface Use<Field extends string = string> {
  /** Fields with a new value that does not depend on the old one. */
  readonly sets?: readonly Field[];
  /** Fields with a new value that depends on the old one. */
  readonly changes?: readonly Field[];
  /** Other fields that it reads. */
  readonly reads?: readonly Field[];
  /** Fields, besides its own, that determine whether it can happen. Without `needs` it can always happen. */
  readonly needs?: readonly Field[];
}

const nothing: Use = {};

/** Sets of fields as bits. */
type Fields = number;
const mostFields = 31;

/** How the events of an algorithm use its fields: sets of fields for each number of an event's name. */
export class Uses {
  readonly written: readonly Fields[];
  readonly set: readonly Fields[];
  /** The fields that must be right before the event. */
  readonly needed: readonly Fields[];
  readonly everything: Fields;
  /** Whether the event may be impossible, or influences whether a later one is possible. */
  readonly decisive: readonly boolean[];

  constructor(private readonly table: Readonly<Partial<Record<EventName, Use>>>) {
    const fields = [...new Set(eventNames.flatMap((name) => this.fieldsOf(name)))];
    if (fields.length > mostFields) throw new RangeError(`${fields.length} fields`);
    const bits = (some: readonly string[] = []): Fields =>
      some.reduce((found, field) => found | (1 << fields.indexOf(field)), 0);
    const each = (of: (use: Use) => Fields): readonly Fields[] =>
      eventNames.map((name) => of(table[name] ?? nothing));
    this.set = each(({ sets }) => bits(sets));
    this.written = each(({ sets, changes }) => bits(sets) | bits(changes));
    this.needed = each(({ changes, reads }) => bits(changes) | bits(reads));
    this.everything = bits(fields);
    this.decisive = this.decisiveNames();
  }

  private decisiveNames(): readonly boolean[] {
    const all = Object.values(this.table);
    const wanted = new Set(all.flatMap(({ needs = [] }) => needs));
    const writes = ({ sets = [], changes = [] }: Use): boolean =>
      [...sets, ...changes].some((field) => wanted.has(field));
    for (let before = -1; before !== wanted.size;) {
      before = wanted.size;
      for (const field of all.filter(writes).flatMap(({ reads = [] }) => reads)) wanted.add(field);
    }
    return eventNames.map((name) => {
      const use = this.table[name] ?? nothing;
      return use.needs !== undefined || writes(use);
    });
  }

  /** All fields that an event uses. */
  fieldsOf(name: EventName): readonly string[] {
    const { sets = [], changes = [], reads = [] } = this.table[name] ?? nothing;
    return [...sets, ...changes, ...reads];
  }
}
