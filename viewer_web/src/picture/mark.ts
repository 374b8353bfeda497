import { toNumber } from '../language/words.js';
import type { Polygon } from '../trace/header.js';
import type { Box, Corner, N } from '../trace/values.js';
import type { Pixel } from './pixel.js';

/** The meaning of a mark; the style sheet of the picture gives each role its look. */
export type Role =
  | 'stacked'
  | 'tree'
  | 'way'
  | 'window'
  | 'fresh'
  | 'off'
  | 'touched'
  | 'scanline'
  | 'edge'
  | 'active'
  | 'clip'
  | 'clip-new'
  | 'side'
  | 'yes'
  | 'no'
  | 'point'
  | 'pointed'
  | 'chosen'
  | 'cursor'
  | 'wrong'
  | 'zero'
  | 'narrow'
  | 'margin'
  | 'reach';

interface PathMark {
  readonly kind: 'path';
  readonly role: Role;
  readonly points: readonly Spot[];
  readonly closed: boolean;
  /** Replaces the role's own colour. */
  readonly color?: string;
}

/** A few letters or digits, centred on a place. */
export interface NoteMark {
  readonly kind: 'note';
  readonly at: Spot;
  readonly text: string;
}

export type Mark =
  | PathMark
  | { readonly kind: 'box'; readonly role: Role; readonly box: Box }
  | { readonly kind: 'boxes'; readonly role: Role; readonly boxes: readonly Box[] }
  | { readonly kind: 'point'; readonly role: Role; readonly at: Spot }
  | NoteMark
  /** A pixel with lines towards it, so that it can be found even where pixels are small. */
  | { readonly kind: 'target'; readonly role: 'chosen' | 'cursor'; readonly at: Pixel };

export type Spot = readonly [number, number];

export const target = (role: 'chosen' | 'cursor', at: Pixel): Mark => ({
  kind: 'target',
  role,
  at,
});

export const note = (at: Spot, text: string): Mark => ({ kind: 'note', at, text });

export const box = (role: Role, of: Box): Mark => ({ kind: 'box', role, box: of });

/** The place where it is drawn; a coordinate of NaN is not drawn. */
export const spot = (at: readonly N[]): Spot => [toNumber(at[0] ?? NaN), toNumber(at[1] ?? NaN)];
export const isShown = (at: Spot): boolean => at.every(Number.isFinite);

export const point = (role: Role, at: readonly N[]): Mark => ({
  kind: 'point',
  role,
  at: spot(at),
});

export const path = (role: Role, points: readonly (readonly N[])[], closed = false): PathMark => ({
  kind: 'path',
  role,
  points: points.map(spot),
  closed,
});

export function edgeOf(polygon: Polygon | undefined, edge: number, role: Role): readonly Mark[] {
  const vertices = polygon?.vertices ?? [];
  const from = vertices[edge];
  const to = vertices[(edge + 1) % vertices.length];
  return from && to ? [path(role, [from, to])] : [];
}

export function cornerOf([x, y, width, height]: Box, corner: Corner): Spot {
  return [corner.startsWith('r') ? x + width : x, corner.endsWith('t') ? y + height : y];
}
