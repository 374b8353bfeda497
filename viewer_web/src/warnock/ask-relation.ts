import { polygonThing, windowThing } from '../algorithm/pointed.js';
import { eventAt, inOrder, nextOf, stepsOf } from '../predict/ahead.js';
import { optionsOf } from '../predict/asker.js';
import type { Asker } from '../predict/asker.js';
import { relations, tests } from '../predict/question.js';
import type { Trace } from '../replay/trace.js';
import { hasThreeLists } from '../trace/events.js';

/** The line that decided. Above the level of signs the earlier tests may have no event. */
function testOf(trace: Trace, step: number, until: number): (typeof tests)[number] {
  const contained = [
    ...stepsOf(trace, step, until, 'crossings'),
    ...stepsOf(trace, step, until, 'angle'),
  ];
  if (contained.length > 0) return 'RE4';
  if (stepsOf(trace, step, until, 'meets').length > 0) return 'RE3';
  return stepsOf(trace, step, until, 'insider').length > 0 ? 'RE2' : 'RE1';
}

/** What is the relation of this polygon to the window, and which test decides it? */
export const relation: Asker<'relation'> = {
  isOf: hasThreeLists,
  from: 'polygons',
  at: ['call'],
  ask(trace, step) {
    if (eventAt(trace, step, 'call')?.of !== 'Relation') return null;
    const result = nextOf(trace, step, 'relation', 'pop');
    const window = trace.timeline.seek(step).values.warnock?.window ?? null;
    if (result === null || window === null) return null;
    const until = result.step;
    const { polygon } = result.event;
    return {
      kind: 'relation',
      step,
      until,
      about: { polygon, window },
      parts: [
        { asks: 'lies', options: optionsOf(relations), right: [result.event.relation] },
        { asks: 'test', options: optionsOf(tests), right: [testOf(trace, step, until)] },
      ],
      because: inOrder(
        stepsOf(trace, step, until, 'box'),
        stepsOf(trace, step, until, 'insider'),
        stepsOf(trace, step, until, 'meets'),
        stepsOf(trace, step, until, 'crossings'),
        stepsOf(trace, step, until, 'angle'),
        [result],
      ),
      things: [polygonThing(polygon), windowThing(window)],
    };
  },
};
