import { eventNames } from '../trace/events.js';
import type { EventName } from '../trace/events.js';

/** For each number of an event's name, whether such events are wanted. Passes over a long run use these numbers. */
export type Wanted = readonly boolean[];

export const all: Wanted = eventNames.map(() => true);

export function only(...names: readonly EventName[]): Wanted {
  return eventNames.map((name) => names.includes(name));
}
