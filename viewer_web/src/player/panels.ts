import type { PageView } from '../base/setting.js';
import type { Side } from '../history/side-name.js';

/** The panels beside the picture. */
export type PanelName = 'listing' | 'side';

/** Which controls of the player are visible. Keys do everything in any view. */
export interface Arrangement {
  /** The panels beside the picture, from top to bottom, or from left to right where there is room. */
  readonly panels: readonly PanelName[];
  /** Whether the time controls are reduced to the most common ones. */
  readonly isBrief: boolean;
}

/** The arrangement of each view. */
const arrangements: Readonly<Record<PageView, Arrangement>> = {
  lesson: { panels: ['listing', 'side'], isBrief: true },
  workbench: { panels: ['listing', 'side'], isBrief: false },
};

export const arrangementOf = (view: PageView): Arrangement => arrangements[view];

/** Whether a view shows the panel now. A lesson shows the panel of state only if it asks for parts of the state. */
export function isShown(panel: PanelName, view: PageView, side: Side, asked: boolean): boolean {
  if (!arrangements[view].panels.includes(panel)) return false;
  return panel !== 'side' || view !== 'lesson' || side !== 'state' || asked;
}
