import { eventNames } from '../trace/events.js';
import type { CommonEvents, EventName } from '../trace/events.js';

/**
 * What an event does with the state before it, by the names of the state's fields. The stack of calls and the lines that
 * were drawn are followed apart.
 */
export interface Use {
  /** Gets a new value, whatever the old one was. */
  readonly sets?: readonly string[];
  /** Gets a value that depends on the old one. */
  readonly changes?: readonly string[];
  /** Is looked at besides. */
  readonly reads?: readonly string[];
  /** It cannot always happen, and this decides besides its own values; else it can. */
  readonly needs?: readonly string[];
}

export const nothing: Use = {};

/** The events that all algorithms tell change nothing, as a rule. */
export const noneOfCommon: Readonly<Record<keyof CommonEvents, Use>> = {
  plane: nothing,
  call: nothing,
  depth: nothing,
  fault: nothing,
  disagree: nothing,
};

/** Sets of fields as bits. */
type Fields = number;
const mostFields = 31;

/** What the events of an algorithm do with its fields: for each number of an event's name sets of fields. */
export class Uses {
  readonly written: readonly Fields[];
  readonly set: readonly Fields[];
  /** What must be right before the event. */
  readonly needed: readonly Fields[];
  readonly everything: Fields;
  /** Whether the event may be impossible, or decides in any way whether a later one is possible. */
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

  /** All that an event has to do with. */
  fieldsOf(name: EventName): readonly string[] {
    const { sets = [], changes = [], reads = [] } = this.table[name] ?? nothing;
    return [...sets, ...changes, ...reads];
  }
}
