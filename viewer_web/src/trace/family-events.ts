import { between, bool, count, oneOf, optional, whole } from './check.js';
import { kind } from './kind.js';
import { id, num } from './values.js';

/** The face of a body. */
export const bodies = {
  back_face: kind(oneOf('BF2'), 'p', { polygon: id, away: bool }),
} as const;

const joinable = oneOf('surrounding', 'outside');
const octant = between(0, 7);

/** With three lists. */
export const lists = {
  rejoin: kind(oneOf('WF3'), 'p', { polygon: id, list: joinable, level: count }),
  join: kind(oneOf('WF4'), 'p', { polygon: id, list: joinable, level: count }),
  relation: kind(oneOf('WF4'), 'p', {
    polygon: id,
    relation: oneOf('outside', 'inside', 'intersecting', 'surrounding'),
  }),
  trial: kind(oneOf('TF3'), 's', { polygon: id, edge: count, meets: bool }),
  meets: kind(oneOf('RE3'), 'p', { polygon: id, meets: bool }),
  ray: kind(oneOf('CR3', 'CR4'), 's', { polygon: id, edge: count, counts: between(0, 2) }),
  crossings: kind(oneOf('RE4'), 'p', { polygon: id, count }),
  octants: kind(oneOf('OA3', 'OA4'), 's', {
    polygon: id,
    edge: count,
    from: octant,
    to: octant,
    difference: between(-4, 4),
  }),
  angle: kind(oneOf('RE4'), 'p', { polygon: id, octants: whole }),
  hiding: kind(oneOf('WF10'), 'p', { polygon: optional(id) }),
  split_vertex: kind(oneOf('VS2'), 'p', {
    polygon: id,
    vertex: count,
    column: whole,
    row: whole,
    splits: bool,
  }),
  edge_depth: kind(oneOf('ED5'), 'p', { polygon: id, edge: count, z: num }),
} as const;
