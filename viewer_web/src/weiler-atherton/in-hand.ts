import type { EventName } from '../trace/events.js';
import type { View } from '../algorithm/view.js';
import type { ListInHand } from './state.js';

const inPainting: readonly EventName[] = ['order', 'paint', 'painted'];

/** Whether the visible regions are being painted, or have been. No list is processed after that. */
export const isPainting = ({ event, after }: Pick<View, 'event' | 'after'>): boolean =>
  after.calls.some(({ of }) => of === 'PaintRegions') ||
  (event !== null && inPainting.includes(event.e));

/** The list that the step processes. The program's variables keep the last one to the end. */
export const listInHand = (view: Pick<View, 'event' | 'after'>): ListInHand | null =>
  isPainting(view) ? null : (view.after.weilerAtherton?.inHand ?? null);
