import type { FloatingHorizonEvents } from '../trace/events.js';

/** The columns of two adjacent samples of the current curve. */
export type Segment = FloatingHorizonEvents['visibility']['segment'];
/** The position of a point relative to the horizons: above, below, hidden, or on both. */
export type Flag = FloatingHorizonEvents['visibility']['flag'];
