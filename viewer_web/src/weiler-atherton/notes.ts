import { compared, half } from '../listing/notation.js';
import type { Notes } from '../listing/notes.js';
import type { WeilerAthertonEvents } from '../trace/events.js';
import type { Region } from '../trace/values.js';
import { verticesOf } from './geometry.js';

const listed = (ids: readonly string[]): string => ids.join(' ') || '∅';
const sized = (region: Region): string => (region.length === 0 ? '∅' : `|${verticesOf(region)}|`);
/**
 * The notes of the events of Weiler and Atherton's algorithm, in the notation of the listing; |n| is a region of n
 * vertices.
 */
export const notes: Pick<Notes, keyof WeilerAthertonEvents> = {
  row: ({ first, end }, numbers) => half([first, end], numbers),
  cut_to_area: ({ polygon, region }) => `${polygon}: ${sized(region)}`,
  pierce: ({ polygon, other }) => `${polygon}, ${other}`,
  split: ({ polygon, region, other }) => `${polygon}: ${sized(region)}, ${sized(other)}`,
  facets: ({ pieces }) => `|L| = ${pieces.length}`,
  greatest_depth: ({ polygon, z }, { short }) => `${polygon}: ${short(z)}`,
  sorted: ({ polygons }) => listed(polygons),
  push_list: ({ pieces }) => listed(pieces.map(([id]) => id)),
  pop_list: ({ clip, count }) => `|L| = ${count}, C = ${clip}`,
  beside: ({ polygon }) => `${polygon}: ∅, ${polygon}`,
  clipped: ({ polygon, inside, outside }) => `${polygon}: ${sized(inside)}, ${sized(outside)}`,
  edge_piece: ({ from, to }, { point }) => `${point(from)} → ${point(to)}`,
  entering: ({ point: at }, { point }) => `→ ${point(at)}`,
  leaving: ({ point: at }, { point }) => `← ${point(at)}`,
  behind: ({ z, clipZ, order: sign }, numbers) => compared(z, clipZ, sign, numbers),
  nearer_ones: ({ polygons }) => `N = ${listed(polygons)}`,
  show: ({ polygon }) => polygon,
  order: ({ z, otherZ, order: sign }, numbers) => compared(z, otherZ, sign, numbers),
  paint: ({ polygon }) => polygon,
  painted: null,
};
