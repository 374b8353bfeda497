import { algorithmOf } from '../algorithm/algorithm.js';
import type { Trace } from '../replay/trace.js';
import { only } from '../replay/wanted.js';
import { details } from '../trace/events.js';
import type { Header } from '../trace/header.js';
import { stepsOf } from './ahead.js';
import type { Asker } from './asker.js';
import { kinds } from './question.js';
import type { Kind, Question } from './question.js';

/** The kinds of question that a trace of this method and detail can answer. */
export function kindsOf({ method, detail }: Header): readonly Kind[] {
  const { askers } = algorithmOf({ method });
  return kinds.filter((kind) => {
    const { isOf, from } = askers[kind] ?? {};
    if (from === undefined || isOf?.(method) === false) return false;
    return details.indexOf(from) <= details.indexOf(detail);
  });
}

/**
 * A subject is not asked about again for this number of steps after its first question, and for twice as many after each further
 * one, up to a limit.
 */
const leastRest = 16;
const mostRest = 512;

/** What a kind is about: a window may be asked about before or after it is popped. */
const subjectOf = (kind: Kind): Kind => (kind === 'pop' ? 'window' : kind);

/** Whether a kind is not to be asked at a step, given the previous questions in order. */
function rests(kind: Kind, step: number, asked: readonly Question[]): boolean {
  const before = asked.filter((question) => subjectOf(question.kind) === subjectOf(kind));
  const rest = Math.min(mostRest, leastRest * 2 ** (before.length - 1));
  return before.some((question) => question.step <= step && step < question.until + rest);
}

/** Whether the steps contain a fault, or a decision that a check found wrong. Nobody can be expected to predict those. */
function goesWrong(trace: Trace, { step, until }: Question, wrong: readonly number[]): boolean {
  const faults = ['disagree', 'fault'] as const;
  return (
    wrong.some((each) => step < each && each <= until) ||
    faults.some((name) => stepsOf(trace, step, until, name).length > 0)
  );
}

/**
 * The next question of some kinds at or after a step. The previous questions vary the next one. A later check may have
 * found steps of the run to be wrong.
 */
export function nextQuestion(
  trace: Trace,
  from: number,
  wanted: ReadonlySet<Kind>,
  asked: readonly Question[],
  wrong: readonly number[] = [],
): Question | null {
  const { names } = trace.timeline;
  const askers: Readonly<Partial<Record<Kind, Asker>>> = algorithmOf(trace.header).askers;
  const chosen = kindsOf(trace.header)
    .filter((kind) => wanted.has(kind))
    .flatMap((kind) => {
      const asker = askers[kind];
      return asker === undefined ? [] : [{ kind, asker, starts: only(...asker.at) }];
    });
  for (let step = Math.max(1, from); step <= names.length; step++) {
    for (const { kind, asker, starts } of chosen) {
      if (starts[names[step - 1] ?? 0] !== true || rests(kind, step, asked)) continue;
      const question = asker.ask(trace, step);
      if (question !== null && !goesWrong(trace, question, wrong)) return question;
    }
  }
  return null;
}
