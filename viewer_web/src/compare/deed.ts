import { eventNames, kinds } from '../trace/events.js';
import type { Event, EventName } from '../trace/events.js';

/** The fields that a check adds. */
const truths: ReadonlySet<string> = new Set(['exact', 'by']);

/** For each event name, the fields that describe the action. */
const deedFields = new Map<EventName, readonly string[]>(
  eventNames.map((name) => {
    const { fields, numbers } = kinds[name];
    return [name, fields.filter((key) => !truths.has(key) && !numbers.includes(key))];
  }),
);

const isSame = (a: unknown, b: unknown): boolean => JSON.stringify(a) === JSON.stringify(b);

/**
 * Whether two events do the same, each with its kernel's numbers: the same line of the listing, polygon, window, pixels,
 * order and answer. The fields of a check do not count.
 */
export function sameDeed(a: Event, b: Event): boolean {
  if (a.e !== b.e || a.at !== b.at) return false;
  const [one, other] = [a, b] as unknown as readonly Readonly<Record<string, unknown>>[];
  return (deedFields.get(a.e) ?? []).every((key) => isSame(one?.[key], other?.[key]));
}
