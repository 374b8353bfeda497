import { kinds } from '../predict/question.js';
import type { Kind, Part, Question } from '../predict/question.js';
import { nextQuestion } from '../predict/questions.js';
import type { Trace } from '../trace/trace.js';

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

/** What each part asks, and the right answer. */
export const answers = ({ parts }: Question): Readonly<Record<string, readonly string[]>> =>
  Object.fromEntries(parts.map(({ asks, right }: Part) => [asks, right]));
