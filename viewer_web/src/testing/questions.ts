import { kinds } from '../predict/question.js';
import type { Kind, Part, Question } from '../predict/question.js';
import { nextQuestion } from '../predict/questions.js';
import type { Values } from '../replay/values.js';
import type { Trace } from '../replay/trace.js';

/** The first question of a kind at or after a step. */
export function questionFrom<K extends Kind>(trace: Trace, from: number, kind: K): Question<K> {
  const found = nextQuestion(trace, from, new Set([kind]), []);
  if (found === null) throw new Error(`no ${kind} from step ${from} on`);
  return found as Question<K>;
}

/** Every question of a run; none suppresses another one. */
export function everyQuestion(trace: Trace): readonly Question[] {
  return kinds.flatMap((kind) => {
    const found: Question[] = [];
    let next = nextQuestion(trace, 1, new Set([kind]), []);
    while (next !== null) {
      found.push(next);
      next = nextQuestion(trace, next.step + 1, new Set([kind]), []);
    }
    return found;
  });
}

/** A question, and the values at its step and after the run has answered it. */
export interface Seen {
  readonly trace: Trace;
  readonly question: Question;
  readonly before: Values;
  readonly after: Values;
  /** The right answers. */
  readonly right: Readonly<Record<string, readonly string[]>>;
}

/** Checks that the state after a question's steps agrees with its right answer. */
export type Agrees = (seen: Seen) => void;

export const sorted = (values: readonly (string | number)[] = []): readonly string[] =>
  values.map(String).sort();

/** The right answer to each part, by what the part asks. */
export const answers = ({ parts }: Question): Readonly<Record<string, readonly string[]>> =>
  Object.fromEntries(parts.map(({ asks, right }: Part) => [asks, right]));
