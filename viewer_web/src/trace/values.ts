import type { N } from './event-table.js';

/** The values that FORMAT.md names, as types. */

export type { Corner, N } from './event-table.js';

export type Color = string;
export type Point = readonly [N, N];
export type Vertex = readonly [N, N, N];
/** A column and the height over it, as in the scene. */
export type Sample = readonly [number, number];
/** Loops with the region always on the same side, so that holes have the opposite direction. */
export type Region = readonly (readonly Point[])[];
/** A part of a polygon, and whether it is known to be behind all others of its list. */
export type Piece = readonly [polygon: string, region: Region, ground: boolean];
export type Box = readonly [x: number, y: number, width: number, height: number];
/** The result of a decision: yes or no, a sign, a pixel, or the range first <= i < end. */
export type Answer = boolean | number | readonly [number, number];
/** The operands of a decision: the names, the numbers of the run, and the right numbers, which may be undefined. */
export type Operands = readonly (readonly [
  name: string,
  computed: string | null,
  exact: string | null,
])[];
