import { count, matching, oneOf, optional, plainObject, record } from './check.js';
import type { Checked } from './check.js';
import { details } from './events.js';
import type { Event } from './events.js';
import type { Header } from './header.js';
import { kindsOf } from './kinds.js';
import { Refusal, describe } from './refusal.js';

const hash = matching(/^sha256:[0-9a-f]{64}$/, 'hash');

/** A complete run has the hash of its picture or of its lines; a stopped run states that it is partial. */
const end = record({
  end: record({
    events: count,
    picture: optional(hash),
    lines: optional(hash),
    partial: optional(oneOf(true)),
  }),
});

export type End = Checked<typeof end>['end'];
export type Line = { readonly event: Event } | { readonly end: End };

/** Throws the reason `empty` for a text without content. */
export function parseJson(text: string, empty: 'emptyFile' | 'emptyLine' = 'emptyFile'): unknown {
  try {
    return JSON.parse(text);
  } catch {
    throw text.trim() === '' ? new Refusal('', empty) : new Refusal('', 'notJson', describe(text));
  }
}

/** A line after the header: an event of the trace's method and level, or the last line. */
export function parseLine(line: string, header: Header): Line {
  const object = plainObject(parseJson(line, 'emptyLine'), '');
  if (!Object.hasOwn(object, 'e')) return { end: end(object, '').end };
  const name = object['e'];
  const known = typeof name === 'string' ? kindsOf[header.method].get(name) : undefined;
  if (known === undefined) {
    throw new Refusal('e', 'noEvent', describe(name), header.method);
  }
  if (details.indexOf(known.from) > details.indexOf(header.detail)) {
    throw new Refusal('e', 'tooDetailed', describe(name), header.detail);
  }
  return { event: known.check(object, '') };
}
