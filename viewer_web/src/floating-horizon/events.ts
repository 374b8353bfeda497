import type { CurveEvents } from '../trace/events.js';

/** From one sample of the current curve to the next: their columns. */
export type Segment = CurveEvents['visibility']['segment'];
/** How a point lies to the horizons: above, below, hidden, or on both. */
export type Flag = CurveEvents['visibility']['flag'];
