import { numberOf } from '../trace/events.js';
import type { Event, EventName } from '../trace/events.js';
import type { Trace } from '../replay/trace.js';

/** A step with its event. */
export interface Step<K extends EventName> {
  readonly step: number;
  readonly event: Event<K>;
}

/** The event of a step, if it has that name. */
export function eventAt<K extends EventName>(
  { timeline }: Trace,
  step: number,
  name: K,
): Event<K> | null {
  const event = timeline.event(step);
  return event?.e === name ? (event as Event<K>) : null;
}

/** The next step of a name after one, unless an event that ends the current item comes first. */
export function nextOf<K extends EventName>(
  trace: Trace,
  after: number,
  name: K,
  ...ends: readonly EventName[]
): Step<K> | null {
  const { names } = trace.timeline;
  const wanted = numberOf.get(name);
  const stops = ends.map((end) => numberOf.get(end));
  let step = after + 1;
  while (step <= names.length && names[step - 1] !== wanted) {
    if (stops.includes(names[step - 1])) return null;
    step++;
  }
  const event = eventAt(trace, step, name);
  return event && { step, event };
}

/** The steps of a name after one step, up to another. */
export function stepsOf<K extends EventName>(
  trace: Trace,
  after: number,
  until: number,
  name: K,
): readonly Step<K>[] {
  const steps = Array.from({ length: until - after }, (_, i) => after + 1 + i);
  const wanted = numberOf.get(name);
  return steps
    .filter((step) => trace.timeline.names[step - 1] === wanted)
    .map((step) => ({ step, event: trace.timeline.event(step) as Event<K> }));
}

/** The numbers of steps in order. */
export function inOrder(...lists: readonly (readonly { readonly step: number }[])[]): number[] {
  return lists
    .flat()
    .map(({ step }) => step)
    .sort((a, b) => a - b);
}
