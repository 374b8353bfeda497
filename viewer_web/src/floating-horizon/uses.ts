import { Uses, noneOfCommon, nothing } from '../replay/uses.js';
import type { Use } from '../replay/uses.js';
import type { CommonEvents, CurveEvents } from '../trace/events.js';

const table: Readonly<Record<keyof CommonEvents | keyof CurveEvents, Use>> = {
  ...noneOfCommon,
  horizons: { sets: ['horizons'] },
  curve: { sets: ['curve', 'place', 'told', 'flags', 'before'], reads: ['horizons'], needs: [] },
  side_edge: { changes: ['edges'] },
  visibility: { changes: ['place', 'flags', 'before'], reads: ['horizons'], needs: [] },
  intersection: nothing,
  draw_line: { changes: ['place'], reads: ['curve'], needs: ['curve'] },
  horizon: { changes: ['horizons'], needs: [] },
  height: { sets: ['told'] },
  raise: { changes: ['horizons'], needs: [] },
  lower: { changes: ['horizons'], needs: [] },
  step: nothing,
};

export const uses = new Uses(table);
