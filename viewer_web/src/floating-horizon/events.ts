import type { CurveEvents } from '../trace/events.js';

/** The columns of two adjacent samples of the current curve. */
export type Segment = CurveEvents['visibility']['segment'];
/** The position of a point relative to the horizons: above, below, hidden, or on both. */
export type Flag = CurveEvents['visibility']['flag'];
