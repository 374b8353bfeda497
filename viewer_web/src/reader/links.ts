import { formatAddress, parseAddress } from './address.js';
import type { Setup } from './address.js';
import type { Language } from '../language/language.js';
import type { PageTexts } from '../language/texts.js';
import type { Lesson } from '../lessons/lessons.js';
import { runLabel } from '../lessons/run-name.js';
import type { LessonStory, Pin } from './story.js';

/** An address that names nothing. */
const nothing = parseAddress('');

/** The address of a lesson, or of a place in its text, with the step of that place. Null if there is no such lesson. */
export type AddressOf = (lesson: string, place?: string) => string | null;

export function addressIn(lessons: readonly Lesson[], setup: Setup): AddressOf {
  return (id, place) => {
    if (!lessons.some((each) => each.id === id)) return null;
    return formatAddress({ ...nothing, setup, lesson: id, at: place ?? null });
  };
}

/** The address of a run beside the text of a lesson. */
export const addressOfRun = (lesson: string | null, trace: string, setup: Setup): string =>
  formatAddress({ ...nothing, setup, lesson, trace });

/** A description of the run of a pin. */
export function runOf(
  pin: Pin,
  story: LessonStory,
  lessons: readonly Lesson[],
  page: PageTexts,
  language: Language,
): string {
  const file = story.traces.get(pin.run);
  const trace = lessons.flatMap(({ traces }) => traces).find((each) => each.file === file);
  if (trace === undefined) return pin.run;
  return runLabel(trace, page, language);
}
