import type { Uses } from './uses.js';

/** What of the events from one step to another matters to the state at the end. */
export interface Stretch {
  readonly end: number;
  /** The steps that change what the state at the end has, in order. */
  readonly changes: readonly number[];
  /** How many of the calls at the beginning were closed. */
  readonly closed: number;
  /** The steps of the calls that are open at the end and were not at the beginning, in order. */
  readonly opened: readonly number[];
}

/**
 * Goes back from the end through the numbers of the events' names, that of step n at n - 1. An event matters if
 * it writes what is needed after it, for the state at the end or for a later event that matters: most of what
 * happened in a window or on a line is forgotten with the next one, and comparisons leave nothing.
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
