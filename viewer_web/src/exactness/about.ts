import { toNumber } from '../language/words.js';
import type { Trace } from '../replay/trace.js';
import { numberOf } from '../trace/events.js';
import type { Event, EventName } from '../trace/events.js';
import type { Polygon } from '../trace/header.js';
import type { N } from '../trace/values.js';
import type { About, Spot } from './mapped-decision.js';

type Vertices = Polygon['vertices'];

export const spotOf = (at: readonly N[]): Spot => [toNumber(at[0] ?? NaN), toNumber(at[1] ?? NaN)];

export function verticesOf({ header }: Trace, id: string): Vertices {
  return header.scene.byId.get(id)?.vertices ?? [];
}

/** Whether a polygon is edge-on and so is shown as a segment. Sign maps have no segments. */
export function isSegment({ header }: Trace, id: string): boolean {
  if (header.method !== 'warnock-edges') return false;
  const [first, ...others] = header.scene.byId.get(id)?.vertices ?? [];
  if (first === undefined) return false;
  const [x, y] = first;
  const ways = others.map((vertex) => [vertex[0] - x, vertex[1] - y] as const);
  return ways.every(([x1, y1]) => ways.every(([x2, y2]) => x1 * y2 === x2 * y1));
}

/** Which of two polygons is nearer at a point? */
export function depths(trace: Trace, at: readonly N[], first: string, second: string): About {
  if (isSegment(trace, first) || isSegment(trace, second)) return null;
  const polygons = [verticesOf(trace, first), verticesOf(trace, second)] as const;
  return [spotOf(at), { depth: { polygons } }];
}

/** The last event of that name between two steps, both included. */
export function last<K extends EventName>(
  { timeline }: Trace,
  step: number,
  name: K,
  since = 1,
): { readonly step: number; readonly event: Event<K> } | null {
  const at = timeline.names.lastIndexOf(numberOf.get(name) ?? -1, step - 1) + 1;
  return at < since ? null : { step: at, event: timeline.event(at) as Event<K> };
}
