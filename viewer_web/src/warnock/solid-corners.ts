import type { View } from '../algorithm/view.js';
import { cornerOf } from '../picture/mark.js';
import { corners } from '../trace/events.js';
import type { Corner, N } from '../trace/values.js';

/** The depths at a corner of the current window. */
export interface CornerDepth {
  readonly corner: Corner;
  readonly at: readonly [x: number, y: number];
  /** The nearest depth before this polygon. */
  readonly stored: N;
  /** The depth of the current polygon's plane, once it is computed. */
  readonly own: N | null;
  /** Whether the current polygon is the nearer one, at the step that decides it. */
  readonly nearer: boolean | null;
}

const isCompared = /^(PW[567]|HP[345])$/;

/** The polygon whose depths at the corners are compared. */
export function comparedPolygon({ event }: View): string | null {
  return event !== null && 'polygon' in event && isCompared.test(event.at) ? event.polygon : null;
}

/** The four corners with their depths; empty if the trace does not have them. */
export function cornerDepths(view: View): readonly CornerDepth[] {
  const { event, before, after } = view;
  const { window = null, depths = [], corners: now } = after.warnock ?? {};
  // The step that copies the nearer depths shows the depths that they were compared with.
  const stored = event?.e === 'nearer' ? before.warnock?.corners : now;
  if (window === null || !stored) return [];
  const isInHand = comparedPolygon(view) !== null;
  return corners.map((corner, i) => ({
    corner,
    at: cornerOf(window, corner),
    stored: stored[corner],
    own: (isInHand ? depths[i] : null) ?? null,
    nearer: answerAt(corner, view),
  }));
}

function answerAt(corner: Corner, { event }: View): boolean | null {
  if (event?.e === 'nearer') return event.corners.includes(corner);
  return event?.e === 'compare' && event.corner === corner ? event.nearer : null;
}
