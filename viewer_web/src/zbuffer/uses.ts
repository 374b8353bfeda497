import { Uses, noneOfCommon, nothing } from '../replay/uses.js';
import type { Use } from '../replay/uses.js';
import type { CommonEvents, ZBufferEvents } from '../trace/events.js';

/** Fields with copies of some values that outlive the polygon. */
const kept = ['last'];

const table: Readonly<Record<keyof CommonEvents | keyof ZBufferEvents, Use>> = {
  ...noneOfCommon,
  clear: { sets: ['picture', 'z'] },
  polygon: { sets: ['polygon', 'edges', 'ael', 'y', 'row', 'nextS', 'nextAel'] },
  edge: { changes: ['edges'] },
  extent: nothing,
  scanline: { sets: ['y', 'row'], changes: kept },
  ael_add: { changes: ['ael'], needs: ['ael'] },
  horizontal: nothing,
  leave: { changes: ['edges', ...kept], sets: ['nextS'], needs: ['edges'] },
  ael_sort: { changes: ['ael', ...kept], sets: ['nextAel'], needs: ['ael'] },
  line: nothing,
  miss: nothing,
  slope: nothing,
  columns: nothing,
  pixel: nothing,
  span: { changes: ['picture', 'z'], reads: ['polygon'], needs: ['polygon'] },
  ael_drop: { changes: ['ael', ...kept], sets: ['nextAel'], needs: ['ael'] },
  ael_step: { changes: ['ael'], needs: ['ael'] },
};

export const uses = new Uses(table);
