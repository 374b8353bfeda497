import type { FloatingHorizon } from '../replay/values.js';
import { hasDefect } from '../trace/editions.js';
import type { Edition } from '../trace/editions.js';
import type { FloatingHorizonEvents } from '../trace/events.js';

/** The position of a point relative to the horizons: above, below, hidden, or on both. */
export type Flag = FloatingHorizonEvents['visibility']['flag'];

/** A column and the result of Visibility for it. */
export type Looked = readonly [x: number, flag: Flag];
/** A height over each column, or none. */
export type Heights = FloatingHorizon['horizons']['upper'];

const none = { upper: [], lower: [] };

/** Before the first step. */
export const emptyFloatingHorizon: FloatingHorizon = {
  curve: null,
  place: { segment: null, previous: null, current: null },
  edges: { left: null, right: null },
  horizons: none,
  before: none,
  flags: [],
  height: null,
};

/** A point of a curve lies above the horizons, below them, or hidden between them. */
type Side = 'above' | 'below' | 'hidden';

/** The side on which a point counts. A point on both sides takes the side of its visible neighbour. */
export function sideBeside(flag: Flag, neighbour: Flag): Side {
  if (flag === 0) return 'hidden';
  if (flag === 2) return neighbour === -1 ? 'below' : 'above';
  return flag === 1 ? 'above' : 'below';
}

/** Whether the printed text finds a point below, but does not draw it (X-H1). */
export const isLostBelow = (flag: Flag, edition: Edition): boolean =>
  flag === -1 && hasDefect(edition, 'x-h1');
