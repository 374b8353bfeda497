import { flags, horizons, meeting } from '../floating-horizon/ask.js';
import { only } from '../history/entry.js';
import { details } from '../trace/events.js';
import type { Header } from '../trace/header.js';
import type { Trace } from '../replay/trace.js';
import { ael } from '../zbuffer/ask-ael.js';
import { behind } from '../weiler-atherton/ask-behind.js';
import { stepsOf } from './ahead.js';
import type { Asker } from './asker.js';
import { clip } from '../warnock/ask-clip.js';
import { octants, ray } from '../warnock/ask-contained.js';
import { corners } from '../warnock/ask-corners.js';
import { entering } from '../weiler-atherton/ask-entering.js';
import { inside } from '../warnock/ask-inside.js';
import { parted } from '../weiler-atherton/ask-parted.js';
import { piercing } from '../weiler-atherton/ask-piercing.js';
import { pixels } from '../zbuffer/ask-pixels.js';
import { point } from '../warnock/ask-point.js';
import { kinds } from './question.js';
import type { Kind, Question } from './question.js';
import { relation } from '../warnock/ask-relation.js';
import { sort } from '../weiler-atherton/ask-sort.js';
import { stack } from '../weiler-atherton/ask-stack.js';
import { walk } from '../weiler-atherton/ask-walk.js';
import { window } from '../warnock/ask-window.js';

const askers: { readonly [K in Kind]: Asker<K> } = {
  window,
  relation,
  ray,
  octants,
  corners,
  inside,
  point,
  clip,
  ael,
  pixels,
  flags,
  horizons,
  meeting,
  piercing,
  sort,
  parted,
  entering,
  walk,
  behind,
  stack,
};

/** The kinds of question that a trace of this method and detail can answer. */
export function kindsOf({ method, detail }: Header): readonly Kind[] {
  const isTold = (kind: Kind): boolean =>
    details.indexOf(askers[kind].from) <= details.indexOf(detail);
  return kinds.filter((kind) => askers[kind].isOf(method) && isTold(kind));
}

/** So many steps a kind rests after its first question, and twice as many after each more, up to a limit. */
const leastRest = 16;
const mostRest = 512;

/** Whether a kind is not to be asked at a step, having been asked in these questions, the last of them last. */
function rests(kind: Kind, step: number, asked: readonly Question[]): boolean {
  const before = asked.filter((question) => question.kind === kind);
  const rest = Math.min(mostRest, leastRest * 2 ** (before.length - 1));
  return before.some((question) => question.step <= step && step < question.until + rest);
}

/** Nobody can be asked to predict what a check has found wrong, nor at what a run fails. */
function goesWrong(trace: Trace, { step, until }: Question): boolean {
  const wrong = ['disagree', 'fault'] as const;
  return wrong.some((name) => stepsOf(trace, step, until, name).length > 0);
}

/** The next question at a step or after it, of some kinds; those that were asked vary what is asked next. */
export function nextQuestion(
  trace: Trace,
  from: number,
  wanted: ReadonlySet<Kind>,
  asked: readonly Question[],
): Question | null {
  const { names } = trace.timeline;
  const chosen = kindsOf(trace.header)
    .filter((kind) => wanted.has(kind))
    .map((kind) => ({ kind, starts: only(...askers[kind].at) }));
  for (let step = Math.max(1, from); step <= names.length; step++) {
    for (const { kind, starts } of chosen) {
      if (starts[names[step - 1] ?? 0] !== true || rests(kind, step, asked)) continue;
      const question = askers[kind].ask(trace, step);
      if (question !== null && !goesWrong(trace, question)) return question;
    }
  }
  return null;
}
