import type { View } from '../algorithm/view.js';
import type { WeilerAtherton } from '../replay/values.js';
import type { EventName } from '../trace/events.js';
import type { Piece } from '../trace/values.js';

export type List = readonly Piece[];
/** The list that was popped from the stack; its first piece is the clip polygon. */
export type CurrentList = NonNullable<WeilerAtherton['currentList']>;
export type Crossings = WeilerAtherton['crossings'];

/** Before the first step. */
export const emptyWeilerAtherton: WeilerAtherton = {
  lists: [],
  currentList: null,
  facets: [],
  visible: [],
  crossings: { entering: [], leaving: [] },
  piercing: null,
};

/** Lines at which loops are closed: a fault there is caused by rounding, and the run continues. */
export const isOpenOutline = (label: string): boolean => ['RC4', 'RC5', 'SP3'].includes(label);

const inPainting: readonly EventName[] = ['order', 'paint', 'painted'];

/** Whether the visible regions are being painted, or have been. No list is processed after that. */
export const isPainting = ({ event, after }: Pick<View, 'event' | 'after'>): boolean =>
  after.calls.some(({ of }) => of === 'PaintRegions') ||
  (event !== null && inPainting.includes(event.e));

/** The list that the step processes. The program's variables keep the last one to the end. */
export const currentListOf = (view: Pick<View, 'event' | 'after'>): CurrentList | null =>
  isPainting(view) ? null : (view.after.weilerAtherton?.currentList ?? null);
