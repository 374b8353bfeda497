import type { Timeline } from '../replay/timeline.js';
import { numberOf } from '../trace/events.js';

const verdict = numberOf.get('disagree') ?? -1;

/**
 * The step of another run that comes after as many events as a step of this one, or its last step. What only tells that a
 * decision was wrong is not counted: the same scene has such events if it was checked.
 */
export function ownStep(from: Timeline, step: number, to: Timeline): number {
  const own = from.names.subarray(0, step).filter((name) => name !== verdict).length;
  let at = 0;
  for (let left = own; left > 0 && at < to.length; at++) if (to.names[at] !== verdict) left--;
  return at;
}
