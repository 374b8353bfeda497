import { describe, expect, it } from 'vitest';
import { viewOf } from '../algorithm/view.js';
import { figureFrame } from '../picture/figure.js';
import { headerOf, keptOf, textOf, textWith, traceOf } from '../testing/traces.js';
import type { Event } from '../trace/events.js';
import type { Region } from '../trace/values.js';
import { allLayers, regionShapes } from './shapes.js';
import { currentListOf } from './state.js';

const header = headerOf('weiler-atherton', 'polygons');

/** The outline of a rectangle. */
const box = (left: number, top: number, right: number, bottom: number): Region => [
  [
    [left, top],
    [right, top],
    [right, bottom],
    [left, bottom],
  ],
];
const far = box(0, 0, 8, 8);
const near = box(2, 2, 4, 4);
const push: Event = {
  e: 'push_list',
  at: 'WA3',
  pieces: [
    ['B', near, false],
    ['A', far, false],
  ],
};
const pop: Event = { e: 'pop_list', at: 'WA4', clip: 'B', count: 2 };
const call: Event = { e: 'call', at: 'WA5', of: 'RegionClip' };
const clipped: Event = {
  e: 'clipped',
  at: 'WA5',
  polygon: 'A',
  clip: 'B',
  inside: near,
  outside: far,
};
const remove: Event = { e: 'call', at: 'WA7', of: 'RemoveBehind' };
const behind = (is: boolean): Event => ({
  e: 'behind',
  at: 'RB3',
  polygon: 'A',
  clip: 'B',
  point: [3, 3],
  z: is ? 0 : 1,
  clipZ: 0.5,
  order: is ? -1 : 1,
  behind: is,
});
const nearerOnes: Event = { e: 'nearer_ones', at: 'WA7', polygons: [] };

describe('the state of Weiler and Atherton’s algorithm', () => {
  it('pops a list from the stack and divides its pieces', async () => {
    const { timeline } = await traceOf(textWith(header, [push, pop, call, clipped]));
    expect(timeline.seek(1).values.weilerAtherton?.lists).toHaveLength(1);
    const { lists, currentList } = timeline.seek(4).values.weilerAtherton ?? {};
    expect(lists).toEqual([]);
    expect(currentList).toMatchObject({
      inside: [['A', near, false]],
      outside: [['A', far, false]],
      seen: 2,
    });
  });

  it.each([
    ['hidden', true, []],
    ['nearer', false, [['A', near, false]]],
  ] as const)('leaves of the parts inside what is not %s', async (_name, is, left) => {
    const events = [push, pop, call, clipped, remove, behind(is), nearerOnes];
    const { timeline } = await traceOf(textWith(header, events));
    expect(timeline.seek(7).values.weilerAtherton?.currentList?.inside).toEqual(left);
  });

  it('puts a piece outside by its bounding box alone', async () => {
    const beside: Event = { e: 'beside', at: 'WA5', polygon: 'A' };
    const { timeline } = await traceOf(textWith(header, [push, pop, beside]));
    expect(timeline.seek(3).values.weilerAtherton?.currentList).toMatchObject({
      inside: [],
      outside: [['A', far, false]],
    });
  });

  it('has the crossings of the current clipping, and of no other', async () => {
    const enter: Event = { e: 'entering', at: 'RC3', point: [2, 2] };
    const leave: Event = { e: 'leaving', at: 'RC3', point: [4, 4] };
    const { timeline } = await traceOf(textWith(header, [push, pop, call, enter, leave, clipped]));
    expect(timeline.seek(5).values.weilerAtherton?.crossings).toEqual({
      entering: [[2, 2]],
      leaving: [[4, 4]],
    });
    expect(timeline.seek(6).values.weilerAtherton?.crossings).toEqual({
      entering: [],
      leaving: [],
    });
  });

  it.each([
    ['the stack of lists is empty', [pop]],
    ['not the list on top of the stack', [push, { ...pop, count: 3 }]],
    ['no current list', [{ e: 'beside', at: 'WA5', polygon: 'A' }]],
    [
      'not the next polygon of the current list',
      [push, pop, { e: 'beside', at: 'WA5', polygon: 'B' }],
    ],
    ['not a depth for each part inside', [push, pop, call, clipped, remove, nearerOnes]],
  ] as const)('refuses what cannot happen: %s', async (reason, events) => {
    const before: Event = { e: 'plane', at: 'I1', polygon: 'A', plane: [0, 0, 1, 0] };
    const { shortened } = await keptOf(textWith(header, [before, ...events]));
    expect(shortened).toMatchObject({ why: 'wrong', line: events.length + 2, reason });
  });
});

const shown = { language: 'en', pixel: null, pointed: null } as const;

it.each(['windows', 'polygons', 'signs'])(
  'no list is current while regions are painted, at level %s',
  async (detail) => {
    const trace = await traceOf(textOf(`wedge.weiler-atherton.${detail}.jsonl`));
    const { timeline } = trace;
    const views = Array.from({ length: timeline.length }, (_, i) => viewOf(trace, i + 1, shown));
    const ofLists = views.filter(({ event }) => event?.e === 'show');
    const ofPainting = views.filter(({ event }) => event?.e === 'paint' || event?.e === 'painted');
    expect(ofLists.length).toBeGreaterThan(0);
    expect(ofPainting.length).toBeGreaterThan(1);
    expect(ofPainting.map(currentListOf)).toEqual(ofPainting.map(() => null));
    expect(ofLists.map(currentListOf)).not.toContain(null);
    const looks = ofPainting.flatMap((view) =>
      regionShapes(view, figureFrame(view), allLayers)
        .filter(({ d }) => d !== '')
        .map(({ look }) => look),
    );
    expect(looks).not.toContain('clip-region');
    // The program's variable keeps the last list, and so do the states of a trace.
    expect(ofPainting.every(({ after }) => after.weilerAtherton?.currentList !== null)).toBe(true);
  },
);
