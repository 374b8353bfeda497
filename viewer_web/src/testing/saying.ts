import { languages } from '../language/language.js';
import { traceOf } from '../replay/trace.js';
import type { Event } from '../trace/events.js';
import { textWith } from './traces.js';

/** What the library says, in each language, of the last event of a run with this header. */
export function saying(header: object, ...events: readonly Event[]): readonly string[] {
  const { timeline, shortened } = traceOf(new TextEncoder().encode(textWith(header, events)));
  if (shortened !== null) throw new Error(`the events are no run: ${JSON.stringify(shortened)}`);
  return languages.map((language) => timeline.sentence(events.length, language));
}

/** What the run computed, without the mark that something else is so. */
export const computedIn = (said: string): string =>
  said.includes('\n') ? said.replace(/\n.*$/su, '').replace(/(?:Computed|Вычислено): /u, '') : said;
