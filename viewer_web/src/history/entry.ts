import type { Known } from '../language/words.js';
import type { Wanted } from '../replay/wanted.js';
import type { Event } from '../trace/events.js';

/** What a step came to for the pixel: a test passed or failed, a colour written, a wrong decision, or neither. */
export type Outcome = 'pass' | 'fail' | 'paint' | 'wrong' | 'note';

/** A step that concerned the pixel, with what its sentence needs to know. */
export interface Entry {
  readonly step: number;
  readonly event: Event;
  readonly outcome: Outcome;
  readonly known: Known;
}

/** Sees the events of a run in turn, those that it wants, and says which concern its pixel. */
export interface Watch {
  readonly wanted: Wanted;
  /** Whether the line of an event that is wanted shows, without being parsed, that the event means nothing here. */
  isElsewhere?(line: string): boolean;
  see(event: Event, step: number): Outcome | null;
  /** What was known when the event happened; asked for after `see`. */
  readonly known: Known;
}

export const test = (passed: boolean): Outcome => (passed ? 'pass' : 'fail');

export const noted = (concerns: boolean): Outcome | null => (concerns ? 'note' : null);

export function covers(runs: readonly (readonly [number, number])[], x: number): boolean {
  return runs.some(([first, end]) => first <= x && x < end);
}
