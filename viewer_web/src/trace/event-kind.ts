import { oneOf, optional } from './check.js';
import type { Check, Fields } from './check.js';
import { truth } from './values.js';

/** What there is to know of an event: its lines of the listing, the detail from which it is told, its fields. */
export interface Kind<L extends string, F extends Fields> {
  readonly at: Check<L>;
  readonly from: Detail;
  readonly fields: F;
}

export const details = ['windows', 'polygons', 'signs'] as const;
export type Detail = (typeof details)[number];

const levels = { w: 'windows', p: 'polygons', s: 'signs' } as const;

export function kind<L extends string, F extends Fields>(
  at: Check<L>,
  from: keyof typeof levels,
  fields: F,
): Kind<L, F> {
  return { at, from: levels[from], fields };
}

/** Beside a decision in a checked trace. */
export const told = {
  exact: optional(truth),
  by: optional(oneOf('given', 'scene', 'operands', 'exact')),
} as const;
