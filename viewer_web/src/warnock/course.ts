import { only } from '../replay/wanted.js';
import { cases } from '../time/course.js';
import type { Book, Watched } from '../time/course.js';
import type { OwnGoal } from '../time/goals.js';

/** The current item is a window. */
export function course({ begin, decide, eventAt }: Book): Watched {
  let level = 0;
  // The levels of the windows on the stack: a pushed window is a part of the current one.
  const stack: number[] = [];
  return {
    push: () => stack.push(level + 1),
    pop: (step) => {
      level = stack.pop() ?? 1;
      begin(step, -1, level);
    },
    decide: (step) => {
      const event = eventAt(step);
      if (event?.e === 'decide') decide(cases.indexOf(event.case));
    },
  };
}

/** The events after the decision to split. */
const splits = only('push', 'skip', 'split_vertex');

export const goals: readonly OwnGoal[] = [
  {
    name: 'split',
    at: ['decide'],
    isGoal: ({ names }, step) => splits[names[step] ?? -1] === true,
  },
];
