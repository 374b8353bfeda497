import { bool, count, list, oneOf, tuple } from '../trace/check.js';
import type { Checked } from '../trace/check.js';
import { told } from '../trace/decisions.js';
import { kind } from '../trace/kind.js';
import { row } from '../trace/row-event.js';
import { color, id, num, pair, runs, sign } from '../trace/values.js';

/** Its loops; each has the region on the same hand, so that holes go the other way round. */
export const region = list(list(pair));
/** A part of a polygon, and whether it is known to be behind all others of its list. */
export const piece = tuple(id, region, bool);
const pieces = list(piece);

export type Region = Checked<typeof region>;
export type Piece = Checked<typeof piece>;

/** The events of Weiler and Atherton's algorithm. */
export const weilerAtherton = {
  cut_to_area: kind(oneOf('WA1'), 'p', { polygon: id, region }),
  pierce: kind(oneOf('SP2'), 'p', { polygon: id, other: id, normal: pair, point: pair }),
  split: kind(oneOf('SP3'), 'p', { polygon: id, region, other: region }),
  facets: kind(oneOf('WA2'), 'p', { pieces }),
  greatest_depth: kind(oneOf('DS1'), 'p', { polygon: id, z: num }),
  sorted: kind(oneOf('WA3'), 'p', { polygons: list(id) }),
  push_list: kind(oneOf('WA3', 'WA6', 'WA9'), 'w', { pieces }),
  pop_list: kind(oneOf('WA4'), 'w', { clip: id, count }),
  beside: kind(oneOf('WA5'), 'p', { polygon: id }),
  clipped: kind(oneOf('WA5', 'SP1'), 'p', {
    polygon: id,
    clip: id,
    inside: region,
    outside: region,
  }),
  edge_piece: kind(oneOf('RC2'), 's', {
    from: pair,
    to: pair,
    lies: oneOf('inside', 'outside', 'same_side', 'other_side'),
  }),
  entering: kind(oneOf('RC3'), 'p', { point: pair }),
  leaving: kind(oneOf('RC3'), 'p', { point: pair }),
  behind: kind(oneOf('RB3'), 'p', {
    polygon: id,
    clip: id,
    point: pair,
    z: num,
    clipZ: num,
    order: sign,
    behind: bool,
    ...told,
  }),
  nearer_ones: kind(oneOf('WA7'), 'p', { polygons: list(id) }),
  show: kind(oneOf('WA8'), 'w', { polygon: id, region }),
  row,
  order: kind(oneOf('PR2', 'PR3'), 's', {
    polygon: id,
    other: id,
    point: pair,
    z: num,
    otherZ: num,
    order: sign,
    ...told,
  }),
  paint: kind(oneOf('PR3'), 'w', { polygon: id, color, runs }),
  painted: kind(oneOf('WA10'), 'p', {}),
} as const;

/** Lines at which loops are closed: a fault there is one of rounding, and the run goes on. */
export const isOpenOutline = (label: string): boolean => ['RC4', 'RC5', 'SP3'].includes(label);
