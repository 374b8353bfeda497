import type { Trace } from '../replay/trace.js';
import { isAlwaysRight } from '../trace/editions.js';
import { eventNames, kinds, numberOf } from '../trace/events.js';

/** In a checked run each of these says what is right. */
const isDecision = eventNames.map((name) => 'exact' in kinds[name].fields);
const disagree = numberOf.get('disagree') ?? -1;

/** Of runs for which it will stay so. */
const seen = new WeakMap<Trace, boolean>();

/**
 * Whether the decisions of a run were held against exact arithmetic. A trace that tells no decision and no wrong one was not, as
 * far as anyone can say.
 */
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

/** What is known of a run's decisions from the trace alone. */
export type Told = 'told' | 'certain' | 'unchecked';

export function toldOf(trace: Trace): Told {
  if (isChecked(trace)) return 'told';
  return isAlwaysRight(trace.header.kernel) ? 'certain' : 'unchecked';
}
