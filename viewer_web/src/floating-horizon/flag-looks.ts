import type { Spot } from '../picture/mark.js';
import { circleData, diamondData } from '../picture/shapes.js';
import type { Flag } from './events.js';

export type FlagLook = 'above' | 'below' | 'hidden' | 'both';
export const flagLooks: Readonly<Record<`${Flag}`, FlagLook>> = {
  1: 'above',
  '-1': 'below',
  0: 'hidden',
  2: 'both',
};

/** A triangle that points towards the curve, a ring for hidden, a diamond for both. */
export const flagData: Readonly<Record<FlagLook, (at: Spot, r: number) => string>> = {
  above: ([x, y], r) => `M${x - r} ${y + 0.7 * r}h${2 * r}l${-r} ${-1.7 * r}Z`,
  below: ([x, y], r) => `M${x - r} ${y - 0.7 * r}h${2 * r}l${-r} ${1.7 * r}Z`,
  hidden: (at, r) => circleData(at, 0.8 * r),
  both: diamondData,
};
