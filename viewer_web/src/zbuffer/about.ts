import { depths, last } from '../exactness/about.js';
import type { About, Abouts } from '../exactness/mapped-decision.js';
import type { Trace } from '../replay/trace.js';
import { numberOf } from '../trace/events.js';
import type { Event } from '../trace/events.js';

/** The number of steps to search back for the polygon with the stored depth. */
const farthest = 20_000;

/** L6: compared with the polygon that the pixel shows. */
function shows(trace: Trace, { x, y }: Event<'pixel'>, step: number): About {
  const pixel = `"x":${x},"y":${y},`;
  for (let at = step - 1; at > Math.max(0, step - farthest); at--) {
    if (trace.timeline.names[at - 1] !== numberOf.get('pixel')) continue;
    if (!trace.timeline.line(at).includes(pixel)) continue;
    const event = trace.timeline.event(at);
    if (event?.e !== 'pixel' || !event.shown) continue;
    const shown = last(trace, at, 'polygon')?.event.polygon;
    const now = last(trace, step, 'polygon')?.event.polygon;
    if (shown === undefined || now === undefined) return null;
    return depths(trace, [x + 0.5, y + 0.5], now, shown);
  }
  return null;
}

export const abouts: Abouts = { pixel: shows };
