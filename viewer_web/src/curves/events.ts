import { bool, count, list, oneOf, optional, tuple, whole } from '../trace/check.js';
import type { Checked } from '../trace/check.js';
import { told } from '../trace/decisions.js';
import { kind } from '../trace/kind.js';
import { num, pair, sample } from '../trace/values.js';

/** From one sample of the curve in hand to the next: their columns. */
const segment = tuple(whole, whole);
/** Of a point on a column twice that column, else the two between which it lies. */
const columns = tuple(whole, whole);
const heights = list(tuple(whole, num));
/** How a point lies to the horizons: above, below, hidden, or on both. */
export const flag = oneOf(1, -1, 0, 2);

export type Segment = Checked<typeof segment>;
export type Flag = Checked<typeof flag>;

/** The events of the floating horizon. */
export const floatingHorizon = {
  horizons: kind(oneOf('FH1'), 'p', { upper: optional(num), lower: optional(num) }),
  curve: kind(oneOf('FH2'), 'w', { curve: count }),
  side_edge: kind(oneOf('FH3', 'FH10'), 'p', { sample }),
  visibility: kind(oneOf('FH4', 'FH5'), 'p', { segment, x: whole, flag, ...told }),
  intersection: kind(oneOf('FH7', 'FH8'), 'p', { segment, point: pair, columns }),
  draw_line: kind(oneOf('FH6', 'FH7', 'FH8'), 'w', {
    segment,
    from: pair,
    fromColumns: columns,
    to: pair,
    toColumns: columns,
  }),
  horizon: kind(oneOf('FH6', 'FH7', 'FH8', 'SE2'), 'p', {
    first: whole,
    last: whole,
    upper: heights,
    lower: heights,
  }),
  height: kind(oneOf('V1'), 's', {
    x: whole,
    y: num,
    upper: optional(num),
    lower: optional(num),
  }),
  raise: kind(oneOf('H2'), 's', { x: whole, y: num }),
  lower: kind(oneOf('H3'), 's', { x: whole, y: num }),
  step: kind(oneOf('IN2'), 's', { x: whole, changes: bool }),
} as const;
