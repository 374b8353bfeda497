import type { Book, Watched } from '../time/course.js';

/** The current item is a list with its clip polygon, until the visible regions are painted. */
export function course({ begin, end, eventAt, indexOf }: Book): Watched {
  let level = 1;
  // The levels of the lists on the stack: a list of inside parts that is tried again is one level below its list; a list of
  // outside parts is not.
  const stack: number[] = [];
  let isPainting = false;
  const paint = (step: number): void => {
    if (!isPainting) end(step);
    isPainting = true;
  };
  return {
    push_list: (step) => {
      const isAgain = eventAt(step)?.at === 'WA9';
      stack.push(isAgain ? level + 1 : level);
    },
    pop_list: (step) => {
      level = stack.pop() ?? 1;
      const event = eventAt(step);
      if (event?.e === 'pop_list') begin(step, indexOf(event.clip), level);
    },
    call: (step) => {
      if (eventAt(step)?.at === 'WA10') paint(step);
    },
    paint,
  };
}
