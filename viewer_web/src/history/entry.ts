import type { Event } from '../trace/events.js';
import type { Box } from '../trace/values.js';

/** What a step means for the pixel: a test passed or failed, a colour written, a wrong decision, or neither. */
export const outcomes = ['pass', 'fail', 'paint', 'wrong', 'note'] as const;
export type Outcome = (typeof outcomes)[number];

/** What was current at a step: a window, a polygon, or a curve. */
export type Heading = Box | string | number;

/** A step that concerns the pixel. */
export interface Entry {
  readonly step: number;
  readonly event: Event;
  readonly outcome: Outcome;
  readonly under: Heading | null;
}
