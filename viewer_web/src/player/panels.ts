import type { PageView } from '../base/page-view.js';
import type { Side } from '../history/side-name.js';

/** What may stand beside the picture. */
export type PanelName = 'listing' | 'side';

/** How much of what the player can do is in sight; keys do all of it in any view. */
export interface Arrangement {
  /** The panels beside the picture, from above, or from the left where there is room. */
  readonly panels: readonly PanelName[];
  /** Whether time has but the ways that everyone needs. */
  readonly isBrief: boolean;
}

/** What each view consists of. */
const arrangements: Readonly<Record<PageView, Arrangement>> = {
  lesson: { panels: ['listing', 'side'], isBrief: true },
  workbench: { panels: ['listing', 'side'], isBrief: false },
};

export const arrangementOf = (view: PageView): Arrangement => arrangements[view];

/** Whether a view shows the panel now: that of the state, in a lesson, only with what the lesson asks for. */
export function isShown(panel: PanelName, view: PageView, side: Side, asked: boolean): boolean {
  if (!arrangements[view].panels.includes(panel)) return false;
  return panel !== 'side' || view !== 'lesson' || side !== 'state' || asked;
}
