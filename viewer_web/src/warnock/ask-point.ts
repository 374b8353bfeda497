import { windowThing } from '../algorithm/pointed.js';
import { eventAt, inOrder, nextOf, stepsOf } from '../predict/ahead.js';
import { depthOptions, mostOptions, optionsOf } from '../predict/asker.js';
import type { Asker } from '../predict/asker.js';
import { none } from '../predict/question.js';
import { shownIn } from './lists.js';

/** Which polygon is visible at this point, and at which depth? */
export const point: Asker<'point'> = {
  from: 'polygons',
  at: ['call'],
  ask(trace, step) {
    if (eventAt(trace, step, 'call')?.of !== 'PointColor') return null;
    const color = nextOf(trace, step, 'color', 'pop');
    if (color === null) return null;
    const until = color.step;
    const now = trace.timeline.seek(step).values.warnock;
    const window = now?.window ?? null;
    const ids = now === undefined ? [] : shownIn(now, trace.header.scene);
    const depths = stepsOf(trace, step, until, 'depth');
    const options = depthOptions(depths.map(({ event }) => event.z));
    const nearest = stepsOf(trace, step, until, 'nearest');
    const winner = nearest.at(-1)?.event;
    if (winner === undefined || options.length < 2 || ids.length > mostOptions) return null;

    const surrounds = stepsOf(trace, step, until, 'surround');
    const covering = depths.map(({ event }) => event.polygon);
    return {
      kind: 'point',
      step,
      until,
      about: { point: color.event.point },
      parts: [
        {
          asks: 'covers',
          options: optionsOf(ids),
          right: covering,
          decidedBy: (id) => surrounds.find(({ event }) => event.polygon === id)?.step,
        },
        { asks: 'wins', options: optionsOf([...ids, none]), right: [winner.polygon] },
        { asks: 'depth', options, right: [String(winner.z)] },
      ],
      because: inOrder(surrounds, depths, nearest, [color]),
      things: window === null ? [] : [windowThing(window)],
    };
  },
};
