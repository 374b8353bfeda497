import type { Check, Fields } from './check.js';

/** What there is to say of the events of a name. */
export interface Kind<L extends string, F extends Fields> {
  readonly at: Check<L>;
  readonly from: Detail;
  readonly fields: F;
}

export const details = ['windows', 'polygons', 'signs'] as const;
export type Detail = (typeof details)[number];

const levels = { w: 'windows', p: 'polygons', s: 'signs' } as const;

/** Of the events of a name: the lines that tell them, the level from which, and their fields. */
export function kind<L extends string, F extends Fields>(
  at: Check<L>,
  from: keyof typeof levels,
  fields: F,
): Kind<L, F> {
  return { at, from: levels[from], fields };
}

export type AnyKind = Kind<string, Fields>;
