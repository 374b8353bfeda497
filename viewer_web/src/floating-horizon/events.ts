import type { FloatingHorizonEvents } from '../trace/events.js';

/** The position of a point relative to the horizons: above, below, hidden, or on both. */
export type Flag = FloatingHorizonEvents['visibility']['flag'];
