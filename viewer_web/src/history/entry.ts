import type { Known } from '../language/words.js';
import type { Wanted } from '../replay/wanted.js';
import type { Event } from '../trace/events.js';

/** The effect of a step on the pixel: a test passed or failed, a colour written, a wrong decision, or neither. */
export type Outcome = 'pass' | 'fail' | 'paint' | 'wrong' | 'note';

/** A step that concerns the pixel, with the data for its sentence. */
export interface Entry {
  readonly step: number;
  readonly event: Event;
  readonly outcome: Outcome;
  readonly known: Known;
}

/** Sees the wanted events of a run in order, and returns the outcome of those that concern its pixel. */
export interface Watch {
  readonly wanted: Wanted;
  /** Whether the text of a wanted event shows, without being parsed, that the event does not concern the pixel. */
  isElsewhere?(line: string): boolean;
  see(event: Event, step: number): Outcome | null;
  /** The data known at the event; read after `see`. */
  readonly known: Known;
}

export const test = (passed: boolean): Outcome => (passed ? 'pass' : 'fail');

export const noted = (concerns: boolean): Outcome | null => (concerns ? 'note' : null);

export function covers(runs: readonly (readonly [number, number])[], x: number): boolean {
  return runs.some(([first, end]) => first <= x && x < end);
}
