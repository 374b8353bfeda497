import { Uses, noneOfCommon, nothing } from '../replay/uses.js';
import type { Use } from '../replay/uses.js';
import type { CommonEvents, RegionEvents } from '../trace/events.js';

const table: Readonly<Record<keyof CommonEvents | keyof RegionEvents, Use>> = {
  ...noneOfCommon,
  cut_to_area: { changes: ['facets'], sets: ['crossings'] },
  pierce: { sets: ['piercing'] },
  split: nothing,
  facets: { sets: ['facets', 'piercing'] },
  greatest_depth: nothing,
  sorted: nothing,
  push_list: { changes: ['lists'] },
  pop_list: { changes: ['lists'], sets: ['inHand'], needs: ['lists'] },
  beside: { changes: ['inHand'], needs: ['inHand'] },
  clipped: { changes: ['inHand'], sets: ['piercing', 'crossings'], needs: ['inHand'] },
  edge_piece: nothing,
  entering: { changes: ['crossings'] },
  leaving: { changes: ['crossings'] },
  behind: { changes: ['inHand'], needs: ['inHand'] },
  nearer_ones: { changes: ['inHand'], needs: ['inHand'] },
  show: { changes: ['visible'] },
  order: nothing,
  paint: { changes: ['picture'], needs: [] },
  painted: nothing,
  row: nothing,
};

export const uses = new Uses(table);
