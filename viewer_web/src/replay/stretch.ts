import type { Uses } from './uses.js';

/** The events between two steps that determine the state at the end. */
export interface Stretch {
  readonly end: number;
  /** The steps that set values of the state at the end, in order. */
  readonly changes: readonly number[];
  /** The number of calls at the beginning that were closed. */
  readonly closed: number;
  /** The steps of the calls that are open at the end and were not at the beginning, in order. */
  readonly opened: readonly number[];
}

/**
 * Goes backwards from the end through the numbers of the events' names; that of step n is at n - 1. An event is relevant if
 * it writes what is needed later, by the state at the end or by a relevant event. The next window or line discards most of
 * the events of the previous one, and comparisons leave nothing.
 */
export function stretch(
  names: Uint8Array,
  begin: number,
  end: number,
  depthChanges: readonly number[],
  { everything, needed, set, written }: Uses,
): Stretch {
  const changes: number[] = [];
  const opened: number[] = [];
  let wanted = everything;
  let closed = 0;
  for (let step = end; step > begin; step--) {
    const name = names[step - 1] ?? 0;
    if (((written[name] ?? 0) & wanted) !== 0) {
      changes.push(step);
      wanted = (wanted & ~(set[name] ?? 0)) | (needed[name] ?? 0);
    }
    const deeper = depthChanges[name] ?? 0;
    if (deeper === 1 && closed === 0) opened.push(step);
    else closed -= deeper;
  }
  return { end, changes: changes.reverse(), closed, opened: opened.reverse() };
}
