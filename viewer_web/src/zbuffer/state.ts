import type { ZBufferValues } from '../trace/event-table.js';

export type ZBuffer = ZBufferValues;
/** An entry of the active edge list. */
export type ActiveEdge = ZBuffer['ael'][number];

const notScanned: ZBuffer['last'] = { y: null, row: null, nextS: null, nextAel: null };

/** Before the first step. */
export const emptyZBuffer: ZBuffer = {
  polygon: null,
  edges: [],
  ael: [],
  ...notScanned,
  last: notScanned,
};
