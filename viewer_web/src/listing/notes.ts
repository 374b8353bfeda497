import { algorithmOf } from '../algorithm/algorithm.js';
import type { Numbers } from '../language/texts.js';
import { withoutDoubledSigns } from '../language/words.js';
import { details, eventsOf, isOfAnyLine, kinds } from '../trace/events.js';
import type { CommonEvents, Detail, Event, EventName, Method } from '../trace/events.js';
import type { Answer } from '../trace/values.js';
import { half } from './notation.js';

/** The note of an event in the notation of the listing; null if it has none. */
export type Note<K extends EventName> = ((event: Event<K>, numbers: Numbers) => string) | null;
export type Notes = { readonly [K in EventName]: Note<K> };

const answer = (value: Answer, numbers: Numbers): string =>
  typeof value === 'object' ? half(value, numbers) : String(value).replace('-', '−');

const common: Pick<Notes, keyof CommonEvents> = {
  plane: ({ plane }, { point }) => point(plane),
  call: null,
  depth: ({ z }, { short }) => short(z),
  fault: ({ reason }, { faultReason }) => faultReason(reason),
  disagree: ({ taken, exact }, numbers) => `${answer(taken, numbers)} ≠ ${answer(exact, numbers)}`,
};

function ownNote(name: EventName, method: Method): Note<EventName> {
  const { notes } = algorithmOf({ method });
  const note = notes[name] ?? (common as Partial<Notes>)[name] ?? null;
  return note as Note<EventName>;
}

/** The note of an event beside its line; null if it has none. */
export function noteOf(event: Event, method: Method, numbers: Numbers): string | null {
  const note = ownNote(event.e, method);
  return note === null ? null : withoutDoubledSigns(note(event, numbers));
}

/** Whether a line of the method's listings can have a note at this level. */
export function speaks(label: string, method: Method, detail: Detail): boolean {
  return eventsOf[method].some((name) => {
    const { at, from } = kinds[name];
    return (
      !isOfAnyLine(name) && // except notes that any line may have
      ownNote(name, method) !== null &&
      details.indexOf(from) <= details.indexOf(detail) &&
      at?.includes(label) === true
    );
  });
}
