import { polygonThing } from '../algorithm/pointed.js';
import { toNumber } from '../language/words.js';
import { eventAt } from '../predict/ahead.js';
import { cellsOf } from '../predict/asker.js';
import type { Asker } from '../predict/asker.js';
import type { Trace } from '../replay/trace.js';
import type { Event } from '../trace/events.js';

/** The planes come first in a run. */
function planeIn(trace: Trace, polygon: string): Event<'plane'>['plane'] | null {
  for (let step = 1; ; step++) {
    const event = eventAt(trace, step, 'plane');
    if (event === null) return null;
    if (event.polygon === polygon) return event.plane;
  }
}

/** What is the depth of this polygon's plane at this point? */
export const depth: Asker<'depth'> = {
  from: 'polygons',
  at: ['count', 'surround'],
  ask(trace, step) {
    const next = eventAt(trace, step + 1, 'depth');
    const plane = next === null ? null : planeIn(trace, next.polygon);
    if (next === null || plane === null) return null;
    const right = cellsOf([next.z]);
    const isLevel = toNumber(plane[0]) === 0 && toNumber(plane[1]) === 0;
    if (isLevel || right === null) return null;
    const { polygon, point } = next;
    return {
      kind: 'depth',
      step,
      until: step + 1,
      about: { polygon, point, plane },
      parts: [{ asks: 'z', options: [], right }],
      because: [step + 1],
      things: [polygonThing(polygon)],
    };
  },
};
