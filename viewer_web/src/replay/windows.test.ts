import { describe, expect, it } from 'vitest';
import { headerOf, textOf, textWith, traceNames, traceOf } from '../testing/traces.js';
import type { Event } from '../trace/events.js';
import type { Area } from '../trace/header.js';
import type { Box } from '../trace/values.js';
import type { Trace } from './trace.js';

const words = (boxes: readonly Box[]): readonly string[] =>
  boxes.map((box) => box.join(' ')).sort();

const everywhere = ({ x, y, width, height }: Area, least = 0) =>
  ({ shown: [x, y, width, height], least }) as const;

/** The leaves at a step by the state. */
function leavesAt({ header, timeline }: Trace, step: number, least = 0): readonly string[] {
  const { area } = header.scene;
  return words(timeline.seek(step).screen.windows(everywhere(area, least)));
}

const holds = ([x, y, width, height]: Box, i: number, j: number): boolean =>
  x <= i + 0.5 && i + 0.5 < x + width && y <= j + 0.5 && j + 0.5 < y + height;

/**
 * The same by brute force: for each pixel the last window that contained it. A window that was partly cut, and not halved,
 * has no remainder.
 */
function replayed(pushed: readonly Box[], { scene, method }: Trace['header']): readonly string[] {
  const { x, y, width, height } = scene.area;
  const found = new Set<Box>();
  for (let j = y; j < y + height; j++) {
    for (let i = x; i < x + width; i++) {
      const last = pushed.filter((window) => holds(window, i, j)).at(-1);
      if (last !== undefined) found.add(last);
    }
  }
  const begins = (window: Box): boolean =>
    pushed.filter((each) => holds(each, window[0], window[1])).at(-1) === window;
  return words([...found].filter((window) => method !== 'warnock-vertex' || begins(window)));
}

const root: Event = { e: 'push', at: 'W3', window: [0, 0, 8, 8], apl: [] };
const pop = (window: Box): Event => ({ e: 'pop', at: 'W5', window });

describe('the windows into which the area is divided', () => {
  it.each(traceNames.filter((name) => name.includes('warnock')))(
    'are those of a replay of the pushes: %s, forward and backward',
    async (name) => {
      const trace = await traceOf(textOf(name));
      const pushed: Box[] = [];
      const expected: (readonly string[])[] = [[]];
      for (let step = 1; step <= trace.timeline.length; step++) {
        const event = trace.timeline.event(step);
        if (event?.e === 'push') pushed.push(event.window);
        expected.push(
          event?.e === 'push' ? replayed(pushed, trace.header) : (expected.at(-1) ?? []),
        );
      }
      expect(expected.at(-1)).not.toEqual([]);
      for (let step = 0; step < expected.length; step++) {
        expect(leavesAt(trace, step)).toEqual(expected[step]);
      }
      for (let step = expected.length - 1; step >= 0; step--) {
        expect(leavesAt(trace, step)).toEqual(expected[step]);
      }
    },
  );

  const quarters = ([x, y, side]: readonly [number, number, number]): readonly Event[] =>
    [
      [x, y],
      [x + side, y],
      [x, y + side],
      [x + side, y + side],
    ].map(([left = 0, top = 0]) => ({ e: 'push', at: 'W13', window: [left, top, side, side] }));

  it('are the smallest distinguishable ones where they are too small', async () => {
    const events = [root, pop([0, 0, 8, 8]), ...quarters([0, 0, 4]), pop([4, 4, 4, 4])];
    const trace = await traceOf(textWith(headerOf('warnock'), [...events, ...quarters([4, 4, 2])]));
    const { length } = trace.timeline;
    const large = ['0 0 4 4', '0 4 4 4', '4 0 4 4'];
    expect(leavesAt(trace, length, 2)).toEqual(
      [...large, '4 4 2 2', '4 6 2 2', '6 4 2 2', '6 6 2 2'].sort(),
    );
    expect(leavesAt(trace, length, 3)).toEqual([...large, '4 4 4 4']);
  });
});

describe('the way to a window', () => {
  const window = (at: 'W13' | 'W5', box: Box): Event =>
    at === 'W5' ? pop(box) : { e: 'push', at, window: box };

  it('is the windows that contain it, from the first one on', async () => {
    const trace = await traceOf(
      textWith(headerOf('warnock'), [
        root,
        window('W5', [0, 0, 8, 8]),
        window('W13', [0, 0, 4, 4]),
        window('W13', [4, 4, 4, 4]),
        window('W5', [4, 4, 4, 4]),
        window('W13', [4, 6, 2, 2]),
        window('W5', [4, 6, 2, 2]),
        window('W5', [0, 0, 4, 4]),
      ]),
    );
    const wayAt = (step: number): unknown => trace.timeline.seek(step).values.warnock?.way;
    expect(wayAt(2)).toEqual([]);
    expect(wayAt(7)).toEqual([
      [0, 0, 8, 8],
      [4, 4, 4, 4],
    ]);
    expect(wayAt(8)).toEqual([[0, 0, 8, 8]]);
  });
});
