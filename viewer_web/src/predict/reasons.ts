import type { Language } from '../language/language.js';
import type { Trace } from '../replay/trace.js';
import type { Part, Question } from './question.js';
import type { Wrong } from './sheet.js';

/** The part of a step that answers a question. */
export interface Reason {
  readonly step: number;
  readonly said: string;
}

/** The reasons for the answer to a question. */
export function reasonsOf(
  { timeline }: Trace,
  { because }: Question,
  language: Language,
): readonly Reason[] {
  return because.map((step) => ({ step, said: timeline.sentence(step, language) }));
}

/** The step that decides the first wrong entry of an answer to a part. */
export const stepAgainst = ({ until }: Question, part: Part, { value, at }: Wrong): number =>
  part.decidedBy?.(value, at) ?? until;
