import { bool, count, list, oneOf, optional, tuple, whole } from './check.js';
import { told } from './decisions.js';
import { kind } from './kind.js';
import { color, id, num, pair, rowRuns, triple } from './values.js';

const edges = list(count);

/** The events of the Z-buffer algorithm. */
export const zbuffer = {
  clear: kind(oneOf('Z1'), 'w', { color, z: num }),
  polygon: kind(oneOf('Z2'), 'w', { polygon: id, color }),
  edge: kind(oneOf('Z3'), 'p', {
    edge: count,
    from: triple,
    to: triple,
    rows: optional(tuple(whole, whole)),
  }),
  extent: kind(oneOf('Z4'), 'p', { ymin: num, ymax: num }),
  scanline: kind(oneOf('Z6'), 'w', { y: num, row: whole }),
  ael_add: kind(oneOf('Z8'), 'p', { edge: count, x: num, z: num, until: num, dx: num, dz: num }),
  horizontal: kind(oneOf('Z9'), 'p', { edge: count }),
  leave: kind(oneOf('Z10'), 'p', { edges, next: num }),
  ael_sort: kind(oneOf('Z12'), 'p', { edges, next: num }),
  line: kind(oneOf('L1'), 'p', { row: whole, from: pair, to: pair }),
  miss: kind(oneOf('L1', 'L2'), 'p', {}),
  slope: kind(oneOf('L3'), 's', { dz: num }),
  columns: kind(oneOf('L4'), 's', { first: whole, end: whole, z: num, ...told }),
  pixel: kind(oneOf('L6'), 's', {
    x: whole,
    y: whole,
    z: num,
    stored: num,
    shown: bool,
    ...told,
  }),
  span: kind(oneOf('Z9', 'Z14'), 'w', { row: whole, runs: rowRuns, depths: optional(list(num)) }),
  ael_drop: kind(oneOf('Z16'), 'p', { edges, next: num }),
  ael_step: kind(oneOf('Z17'), 'p', { edge: count, x: num, z: num }),
} as const;
