import { hasDefect } from '../trace/editions.js';
import type { Edition } from '../trace/editions.js';
import type { Flag } from './events.js';

/** A point of a curve lies above the horizons, below them, or hidden between them. */
export type Side = 'above' | 'below' | 'hidden';

/** The side on which a point counts. A point on both sides takes the side of its visible neighbour. */
export function sideBeside(flag: Flag, neighbour: Flag): Side {
  if (flag === 0) return 'hidden';
  if (flag === 2) return neighbour === -1 ? 'below' : 'above';
  return flag === 1 ? 'above' : 'below';
}

/** Whether the printed text finds a point below, but does not draw it (X-H1). */
export const isLostBelow = (flag: Flag, edition: Edition): boolean =>
  flag === -1 && hasDefect(edition, 'x-h1');
