import { eventAt, nextOf, stepsOf } from '../predict/ahead.js';
import type { Step } from '../predict/ahead.js';
import type { Trace } from '../replay/trace.js';
import type { Event } from '../trace/events.js';
import type { Piece } from '../trace/values.js';

/** The polygons of these pieces, each once. */
export const ownersOf = (pieces: readonly Piece[]): readonly string[] => [
  ...new Set(pieces.map(([id]) => id)),
];

/** A piece of the current list that is clipped by the first one. */
interface Clipping {
  readonly clip: Piece;
  /** The outline of the piece, split at its intersections with the clip polygon. */
  readonly outline: readonly Event<'edge_piece'>[];
  readonly result: Step<'clipped'>;
}

/** The clipping that begins at a step; null if none does. */
export function clippingAt(trace: Trace, step: number): Clipping | null {
  const call = eventAt(trace, step, 'call');
  if (call?.of !== 'RegionClip' || call.at !== 'WA5') return null;
  const result = nextOf(trace, step, 'clipped', 'pop_list');
  const clip = trace.timeline.seek(step).values.weilerAtherton?.inHand?.pieces[0];
  if (result === null || clip === undefined) return null;
  const outline = stepsOf(trace, step, result.step, 'edge_piece').map(({ event }) => event);
  return { clip, outline, result };
}
