/**
 * Milliseconds of rest before anything is computed for a run beyond what a frame needs. During a drag, no run rests that
 * long.
 */
export const rest = 150;
