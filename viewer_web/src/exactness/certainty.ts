import type { Trace } from '../replay/trace.js';
import { isAlwaysRight } from '../trace/editions.js';
import { eventNames, kinds, numberOf } from '../trace/events.js';

/** In a checked run each of these events has the right answer. */
const isDecision = eventNames.map((name) => kinds[name].fields.includes('exact'));
const disagree = numberOf.get('disagree') ?? -1;

/** The runs whose answer is final. */
const seen = new WeakMap<Trace, boolean>();

/** Whether the decisions of a run were compared with exact arithmetic. A trace without any decision counts as unchecked. */
export function isChecked(trace: Trace): boolean {
  const known = seen.get(trace);
  if (known !== undefined) return known;
  const { timeline } = trace;
  const { names } = timeline;
  const first = names.findIndex((name) => isDecision[name] === true);
  const found =
    names.includes(disagree) || (first >= 0 && timeline.line(first + 1).includes('"exact":'));
  if (found || trace.complete) seen.set(trace, found);
  return found;
}

/** What the trace alone reveals about a run's decisions. */
export type Certainty = 'checked' | 'certain' | 'unchecked';

export function certaintyOf(trace: Trace): Certainty {
  if (isChecked(trace)) return 'checked';
  return isAlwaysRight(trace.header.kernel) ? 'certain' : 'unchecked';
}
