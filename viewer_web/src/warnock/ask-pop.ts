import { windowThing } from '../algorithm/pointed.js';
import { box } from '../picture/mark.js';
import { nextOf } from '../predict/ahead.js';
import { mostOptions, optionsOf } from '../predict/asker.js';
import type { Asker } from '../predict/asker.js';
import type { Option } from '../predict/question.js';
import { cases } from '../time/course.js';
import type { Box } from '../trace/values.js';

const valueOf = (window: Box): string => window.join(' ');

const optionOf = (window: Box): Option => ({
  value: valueOf(window),
  note: ({ numbers }) => numbers.windowText(window),
  places: [box('pointed', window)],
});

/** From the upper left on, which does not show the order of the stack. */
const byPlace = ([x, y]: Box, [otherX, otherY]: Box): number => y - otherY || x - otherX;

/** Which window is next, and which case is it? */
export const pop: Asker<'pop'> = {
  from: 'windows',
  at: ['push'],
  ask(trace, step) {
    const popped = nextOf(trace, step, 'pop', 'push');
    const decide = popped && nextOf(trace, popped.step, 'decide', 'pop');
    const { stack = [], window = null } = trace.timeline.seek(step).values.warnock ?? {};
    if (popped === null || decide === null || window === null) return null;
    if (stack.length < 2 || stack.length > mostOptions) return null;
    return {
      kind: 'pop',
      step,
      until: decide.step,
      about: { divided: window },
      parts: [
        {
          asks: 'popped',
          options: stack
            .map((each) => each.window)
            .sort(byPlace)
            .map(optionOf),
          right: [valueOf(popped.event.window)],
          decidedBy: () => popped.step,
        },
        { asks: 'case', options: optionsOf(cases), right: [decide.event.case] },
      ],
      because: [popped.step, decide.step],
      things: [windowThing(window)],
    };
  },
};
