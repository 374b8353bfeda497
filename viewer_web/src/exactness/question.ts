import { toNumber } from '../i18n/words.js';
import { cornerOf } from '../picture/mark.js';
import { numberOf } from '../trace/events.js';
import type { Event, EventName } from '../trace/events.js';
import type { Polygon } from '../trace/header.js';
import type { Trace } from '../trace/trace.js';
import type { Corner, N } from '../trace/values.js';
import { placesAround } from './places.js';
import type { Places } from './places.js';

/** What a decision asks of a point, as a file of a sign map has it; lessons/maps/README.md says what each means. */
type Asked =
  | {
      readonly orientation: { readonly q: Spot; readonly r: Spot; readonly pivot: 'p' | 'q' | 'r' };
    }
  | { readonly surround: { readonly polygon: readonly Spot[] } }
  | { readonly depth: { readonly polygons: readonly [Vertices, Vertices] } };
type Vertices = Polygon['vertices'];
type Spot = readonly [x: number, y: number];

/** A decision about a point, to be asked at its neighbours as well. */
export interface MappedDecision {
  readonly at: Spot;
  readonly places: Places;
  readonly asked: Asked;
}

/** So far back is looked for who has the depth that another is compared with. */
const farthest = 20_000;

const spotOf = (at: readonly N[]): Spot => [toNumber(at[0] ?? NaN), toNumber(at[1] ?? NaN)];

/** The decision of a step; null if it decides nothing about a point. */
export function mappedDecisionOf(trace: Trace, step: number): MappedDecision | null {
  const found = aboutPoint(trace, step);
  if (found === null) return null;
  const [at, asked] = found;
  const places = placesAround(at, trace.header.kernel);
  return places && { at, places, asked };
}

/** The text of the decision's file. */
export function mappedDecisionText({ places: { p, step }, asked }: MappedDecision): string {
  return JSON.stringify({ format: 'vidno-question/1', p, step, ...asked });
}

type About = readonly [at: Spot, asked: Asked] | null;

const about: {
  readonly [K in EventName]?: (trace: Trace, event: Event<K>, step: number) => About;
} = {
  disagree: (trace, _, step) => aboutPoint(trace, step - 1),
  orient: orientation,
  clip_sign: sideOf,
  surround: (trace, { polygon, point }) =>
    isSegment(trace, polygon)
      ? null
      : [spotOf(point), { surround: { polygon: verticesOf(trace, polygon).map(spotOf) } }],
  compare: nearer,
  pixel: shows,
};

function aboutPoint(trace: Trace, step: number): About {
  const event = trace.timeline.event(step);
  if (event === null) return null;
  const find = about[event.e] as ((trace: Trace, event: Event, step: number) => About) | undefined;
  return find?.(trace, event, step) ?? null;
}

function verticesOf({ header }: Trace, id: string): Vertices {
  return header.scene.byId.get(id)?.vertices ?? [];
}

/** A polygon edge-on, where it shows: what is asked of a segment no map tells. */
function isSegment({ header }: Trace, id: string): boolean {
  if (header.method !== 'warnock-edges') return false;
  const [first, ...others] = header.scene.byId.get(id)?.vertices ?? [];
  if (first === undefined) return false;
  const [x, y] = first;
  const ways = others.map((vertex) => [vertex[0] - x, vertex[1] - y] as const);
  return ways.every(([x1, y1]) => ways.every(([x2, y2]) => x1 * y2 === x2 * y1));
}

/** S2, S3: (to - from) x (point - from). */
function orientation(trace: Trace, { polygon, edge, point }: Event<'orient'>): About {
  const vertices = verticesOf(trace, polygon);
  const from = vertices[edge];
  const to = vertices[(edge + 1) % vertices.length];
  if (from === undefined || to === undefined) return null;
  return [spotOf(point), { orientation: { q: spotOf(from), r: spotOf(to), pivot: 'q' } }];
}

/** PL3, PL4: the differences are taken from the side's second corner, F_i. */
function sideOf(trace: Trace, { vertex }: Event<'clip_sign'>, step: number): About {
  const side = last(trace, step, 'clip_side');
  if (side === null) return null;
  const { from, to } = side.event;
  return [spotOf(vertex), { orientation: { q: spotOf(from), r: spotOf(to), pivot: 'r' } }];
}

/** PW6, HP4, PC4: against the polygon that was the nearest so far. */
function nearer(trace: Trace, { polygon, corner }: Event<'compare'>, step: number): About {
  const pop = last(trace, step, 'pop');
  if (pop === null) return null;
  const { window } = pop.event;
  const owner =
    corner === undefined
      ? last(trace, step, 'nearest', pop.step)?.event.polygon
      : ownerOf(trace, step, corner, pop.step);
  const at =
    corner === undefined ? last(trace, step, 'depth')?.event.point : cornerOf(window, corner);
  return owner && at ? depths(trace, at, polygon, owner) : null;
}

/** Who has the depth at a corner of the window: the last one that was nearer there. */
function ownerOf(trace: Trace, step: number, corner: Corner, since: number): string | null {
  let found = last(trace, step, 'nearer', since);
  while (found !== null && !found.event.corners.includes(corner)) {
    found = last(trace, found.step - 1, 'nearer', since);
  }
  return found?.event.polygon ?? null;
}

/** L6: against the polygon that the pixel shows. */
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

function depths(trace: Trace, at: readonly N[], first: string, second: string): About {
  if (isSegment(trace, first) || isSegment(trace, second)) return null;
  const polygons = [verticesOf(trace, first), verticesOf(trace, second)] as const;
  return [spotOf(at), { depth: { polygons } }];
}

/** The last event of that name from one step on to another, these included. */
function last<K extends EventName>(
  { timeline }: Trace,
  step: number,
  name: K,
  since = 1,
): { readonly step: number; readonly event: Event<K> } | null {
  const at = timeline.names.lastIndexOf(numberOf.get(name) ?? -1, step - 1) + 1;
  return at < since ? null : { step: at, event: timeline.event(at) as Event<K> };
}
