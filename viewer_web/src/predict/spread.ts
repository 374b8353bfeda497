import type { Trace } from '../replay/trace.js';
import type { Kind, Question } from './question.js';
import { kindsOf, nextQuestion } from './questions.js';

/** At most the given number of questions of a kind, spread over the run. */
function paced(trace: Trace, kind: Kind, count: number): readonly Question[] {
  const stride = trace.timeline.length / count;
  const wanted = new Set([kind]);
  const found: Question[] = [];
  let next = nextQuestion(trace, 1, wanted, []);
  while (next !== null) {
    found.push(next);
    const from = Math.max(next.until, Math.ceil(next.step + stride));
    next = nextQuestion(trace, from, wanted, []);
  }
  return found;
}

/** The given number of items, spread over a whole list. */
const thinned = <T>(list: readonly T[], count: number): readonly T[] =>
  list.filter(
    (_, i) => Math.floor((i * count) / list.length) !== Math.floor(((i - 1) * count) / list.length),
  );

/** At most the given number of questions from the whole run, evenly by kind; always the same ones. */
export function spread(trace: Trace, count: number): readonly Question[] {
  const byKind = kindsOf(trace.header)
    .map((kind) => paced(trace, kind, count))
    .sort((a, b) => a.length - b.length);
  const chosen: Question[] = [];
  // The rare kinds come first, and the others share the rest.
  byKind.forEach((questions, i) => {
    const share = Math.floor((count - chosen.length) / (byKind.length - i));
    chosen.push(...thinned(questions, Math.min(share, questions.length)));
  });
  return chosen.sort((a, b) => a.step - b.step);
}
