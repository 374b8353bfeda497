import type { Flag } from './events.js';

export type Spot = readonly [x: number, y: number];

export const circle = ([x, y]: Spot, r: number): string =>
  `M${x - r} ${y}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0Z`;

export type FlagLook = 'above' | 'below' | 'hidden' | 'both';
export const flagLooks: Readonly<Record<`${Flag}`, FlagLook>> = {
  1: 'above',
  '-1': 'below',
  0: 'hidden',
  2: 'both',
};

/** A triangle that points to where the curve is, a ring for hidden, a diamond for both. */
export const flagData: Readonly<Record<FlagLook, (at: Spot, r: number) => string>> = {
  above: ([x, y], r) => `M${x - r} ${y + 0.7 * r}h${2 * r}l${-r} ${-1.7 * r}Z`,
  below: ([x, y], r) => `M${x - r} ${y - 0.7 * r}h${2 * r}l${-r} ${1.7 * r}Z`,
  hidden: (at, r) => circle(at, 0.8 * r),
  both: ([x, y], r) => `M${x - r} ${y}l${r} ${-r}l${r} ${r}l${-r} ${r}Z`,
};
