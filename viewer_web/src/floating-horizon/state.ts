import type { FloatingHorizon } from '../replay/values.js';
import type { Flag } from './events.js';

export type { FloatingHorizon } from '../replay/values.js';
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
