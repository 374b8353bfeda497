import type { Timeline } from '../replay/timeline.js';
import { numberOf } from '../trace/events.js';

const verdict = numberOf.get('disagree') ?? -1;

/**
 * The step of another run after the same number of events as a step of this run, or its last step. Events that only report
 * a wrong decision do not count, because only checked runs of a scene have them.
 */
export function ownStep(from: Timeline, step: number, to: Timeline): number {
  const own = from.names.subarray(0, step).filter((name) => name !== verdict).length;
  let at = 0;
  for (let left = own; left > 0 && at < to.length; at++) if (to.names[at] !== verdict) left--;
  return at;
}
