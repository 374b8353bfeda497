import { oneOf, optional } from './check.js';
import { truth } from './values.js';

/** What may be decided, as a checked trace names it. */
export const decisions = [
  'comparison',
  'orientation',
  'nearer',
  'outside',
  'inside',
  'first_centre',
  'last_centre',
  'rows',
  'columns',
  'same_rounded',
  'pixel',
  'visibility',
  'left_of',
  'parallel',
] as const;
export type Decision = (typeof decisions)[number];

/** Beside a decision in a checked trace. */
export const told = {
  exact: optional(truth),
  by: optional(oneOf('given', 'scene', 'operands', 'exact')),
} as const;
