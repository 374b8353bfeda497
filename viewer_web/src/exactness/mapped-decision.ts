import { algorithmOf } from '../algorithm/algorithm.js';
import type { Trace } from '../replay/trace.js';
import type { Event, EventName } from '../trace/events.js';
import type { Polygon } from '../trace/header.js';
import { placesAround } from './places.js';
import type { Places } from './places.js';

/** A decision about a point, as in the file of a sign map, which lessons/maps/README.md explains. */
type Asked =
  | {
      readonly orientation: { readonly q: Spot; readonly r: Spot; readonly pivot: 'p' | 'q' | 'r' };
    }
  | { readonly surround: { readonly polygon: readonly Spot[] } }
  | { readonly depth: { readonly polygons: readonly [Vertices, Vertices] } };
type Vertices = Polygon['vertices'];
export type Spot = readonly [x: number, y: number];

/** A decision about a point, and the neighbours at which to repeat it. */
export interface MappedDecision {
  readonly at: Spot;
  readonly places: Places;
  readonly asked: Asked;
}

/** The decision of an event as it is mapped; null if it is not about a point. */
export type About = readonly [at: Spot, asked: Asked] | null;

/** The mapped decisions by the names of the events that contain them. */
export type Abouts = {
  readonly [K in EventName]?: (trace: Trace, event: Event<K>, step: number) => About;
};

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

function aboutPoint(trace: Trace, step: number): About {
  const event = trace.timeline.event(step);
  if (event === null) return null;
  if (event.e === 'disagree') return aboutPoint(trace, step - 1);
  const find = algorithmOf(trace.header).abouts[event.e] as
    ((trace: Trace, event: Event, step: number) => About) | undefined;
  return find?.(trace, event, step) ?? null;
}
