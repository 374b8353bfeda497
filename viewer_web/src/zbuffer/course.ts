import type { Book, Watched } from '../time/course.js';
import type { OwnGoal } from '../time/goals.js';
import type { Event } from '../trace/events.js';

/** Whether an event changes the active edge list. */
export function changesAel(event: Event | null): boolean {
  return event?.e === 'ael_add' || (event?.e === 'ael_drop' && event.edges.length > 0);
}

/** The current item is a polygon. */
export function course({ begin, changeAel, eventAt, indexOf }: Book): Watched {
  const look = (step: number): void => {
    if (changesAel(eventAt(step))) changeAel(step);
  };
  return {
    polygon: (step) => {
      const event = eventAt(step);
      if (event?.e === 'polygon') begin(step, indexOf(event.polygon));
    },
    ael_add: changeAel,
    ael_drop: look,
  };
}

export const goals: readonly OwnGoal[] = [
  {
    name: 'ael',
    at: ['ael_add', 'ael_drop'],
    isGoal: (timeline, step) => changesAel(timeline.event(step)),
  },
];
