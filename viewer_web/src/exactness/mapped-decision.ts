import { algorithmOf } from '../algorithm/algorithm.js';
import type { Trace } from '../replay/trace.js';
import type { Event, EventName } from '../trace/events.js';
import type { Polygon } from '../trace/header.js';
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
export type Spot = readonly [x: number, y: number];

/** A decision about a point, to be asked at its neighbours as well. */
export interface MappedDecision {
  readonly at: Spot;
  readonly places: Places;
  readonly asked: Asked;
}

/** What is asked of a decision about a point; null where it is about none. */
export type About = readonly [at: Spot, asked: Asked] | null;

/** By the names of the events that tell the decisions. */
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
