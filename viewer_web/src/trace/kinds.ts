import { plainOf, record, text } from './check.js';
import type { Check } from './check.js';
import { eventsOf, kinds, methods, numberOf } from './events.js';
import type { AnyKind, Detail, Event, EventName, Method } from './events.js';

/** The properties of an event's lines. */
export interface LineKind {
  readonly name: EventName;
  readonly number: number;
  readonly from: Detail;
  readonly check: Check<Event>;
  /** Such a line, newline included, as a run writes it: a text that it matches need not be checked. The first
   * group is the JSON of the polygon that it names. */
  readonly plain: RegExp;
}

function plainLine(name: string, { at, fields }: AnyKind): RegExp {
  const written = Object.entries(fields).map(([key, check]) => {
    const value = key === 'polygon' ? `(${plainOf(check)})` : plainOf(check);
    return check.optional === true ? `(?:,"${key}":${value})?` : `,"${key}":${value}`;
  });
  return new RegExp(`\\{"e":"${name}","at":${plainOf(at)}${written.join('')}\\}\\n`, 'y');
}

function lineKinds(method: Method): ReadonlyMap<string, LineKind> {
  return new Map(
    eventsOf[method].map((name) => {
      const kind = kinds[name];
      const check = record({ e: text, at: kind.at, ...kind.fields }) as unknown as Check<Event>;
      const number = numberOf.get(name) ?? 0;
      return [name, { name, number, from: kind.from, check, plain: plainLine(name, kind) }];
    }),
  );
}

/** The line kinds of each method. */
export const kindsOf = Object.fromEntries(
  methods.map((method) => [method, lineKinds(method)]),
) as Readonly<Record<Method, ReadonlyMap<string, LineKind>>>;
