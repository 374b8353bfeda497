import type { EventName } from '../trace/events.js';
import type { View } from '../algorithm/view.js';
import type { ListInHand } from './state.js';

const inPainting: readonly EventName[] = ['order', 'paint', 'painted'];

/** Whether what is visible is being painted, or has been: no list is looked at any more. */
export const isPainting = ({ event, after }: Pick<View, 'event' | 'after'>): boolean =>
  after.calls.some(({ of }) => of === 'PaintRegions') ||
  (event !== null && inPainting.includes(event.e));

/** The list that the step looks at; the program's variables hold the last one to the end. */
export const listInHand = (view: Pick<View, 'event' | 'after'>): ListInHand | null =>
  isPainting(view) ? null : (view.after.regions?.inHand ?? null);
