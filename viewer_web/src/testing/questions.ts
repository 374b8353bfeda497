import { kinds } from '../predict/question.js';
import type { Kind, Part, Question } from '../predict/question.js';
import { nextQuestion } from '../predict/questions.js';
import type { Values } from '../replay/state.js';
import type { Trace } from '../replay/trace.js';

/** The first question of a kind from a step on. */
export function questionFrom<K extends Kind>(trace: Trace, from: number, kind: K): Question<K> {
  const found = nextQuestion(trace, from, new Set([kind]), []);
  if (found === null) throw new Error(`no ${kind} from step ${from} on`);
  return found as Question<K>;
}

/** Every question of a run, none of which makes another one rest. */
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

/** A question, and what is known at its step and once the run has answered it. */
export interface Seen {
  readonly trace: Trace;
  readonly question: Question;
  readonly before: Values;
  readonly after: Values;
  /** The right answers. */
  readonly right: Readonly<Record<string, readonly string[]>>;
}

/** Whether what the state says after a question's steps is what the question has for right. */
export type Agrees = (seen: Seen) => void;

export const sorted = (values: readonly (string | number)[] = []): readonly string[] =>
  values.map(String).sort();

/** What each part asks, and the right answer. */
export const answers = ({ parts }: Question): Readonly<Record<string, readonly string[]>> =>
  Object.fromEntries(parts.map(({ asks, right }: Part) => [asks, right]));
