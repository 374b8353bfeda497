import { Uses, noneOfCommon, nothing } from '../replay/uses.js';
import type { Use } from '../replay/uses.js';
import type { CommonEvents, CurveEvents } from '../trace/events.js';

const table: Readonly<Record<keyof CommonEvents | keyof CurveEvents, Use>> = {
  ...noneOfCommon,
  horizons: { sets: ['horizons'] },
  curve: { sets: ['curve', 'place', 'told', 'flags', 'before'], reads: ['horizons'] },
  side_edge: { changes: ['edges'] },
  visibility: { changes: ['place', 'flags', 'before'], reads: ['horizons'] },
  intersection: nothing,
  draw_line: { changes: ['place'], reads: ['curve'] },
  horizon: { changes: ['horizons'] },
  height: { sets: ['told'] },
  raise: { changes: ['horizons'] },
  lower: { changes: ['horizons'] },
  step: nothing,
};

export const uses = new Uses(table);
