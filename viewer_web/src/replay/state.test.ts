import { describe, expect, it } from 'vitest';
import { samples } from '../testing/samples.js';
import { headerOf, keptOf, pop, push, textOf, textWith, traceOf } from '../testing/traces.js';
import type { Event } from '../trace/events.js';
import type { Entry, Warnock } from './values.js';

describe('both methods paint the same picture', () => {
  it.each(['windows', 'polygons', 'signs'])('at level %s', async (detail) => {
    const pictures = await Promise.all(
      ['warnock', 'zbuffer'].map(async (method) => {
        const { timeline } = await traceOf(textOf(`small.${method}.${detail}.jsonl`));
        const { picture } = timeline.seek(timeline.length).screen;
        // One that nothing has painted is background in a finished run.
        return Array.from({ length: picture.height }, (_, j) =>
          Array.from(picture.row(j), (pixel) => pixel & 0xffffff),
        );
      }),
    );
    expect(pictures[0]).toEqual(pictures[1]);
  });
});

describe('a list of active polygons', () => {
  const discard: Event = { e: 'discard', at: 'PW3', polygon: 'A' };

  /** The list of the current window, and that of the part on the stack. */
  async function listsAfter(part: Event): Promise<readonly (readonly Entry[] | undefined)[]> {
    const { timeline } = await traceOf(textWith(headerOf('warnock'), [push, pop, part, discard]));
    const { apl, stack }: Partial<Warnock> = timeline.valuesAt(4).warnock ?? {};
    return [apl?.entries, stack?.[0]?.apl.entries];
  }

  it('is copied for a part of the window', async () => {
    expect(await listsAfter({ e: 'push', at: 'W13', window: [0, 0, 4, 4] })).toEqual([
      [['B', false]],
      [
        ['A', false],
        ['B', false],
      ],
    ]);
  });

  it('is the same for both windows if it is shared', async () => {
    const part: Event = { e: 'push', at: 'W13', window: [0, 0, 4, 4], shared: true };
    expect(await listsAfter(part)).toEqual([[['B', false]], [['B', false]]]);
  });
});

const [pushed, , part] = samples.push;
const first = <T>(list: readonly T[]): T => {
  const [item] = list;
  if (item === undefined) throw new Error('an empty list of samples');
  return item;
};
const popped: Event = { e: 'pop', at: 'W5', window: [0, 0, 8, 8] };
const started = pushed ? [pushed, popped] : [];
const polygon = first(samples.polygon);
const added = first(samples.ael_add);

const impossible: readonly (readonly [string, 'warnock' | 'zbuffer', readonly Event[], string])[] =
  [
    ['pop of nothing', 'warnock', [popped], 'the stack AW is empty'],
    [
      'pop of another window',
      'warnock',
      [first(samples.push), first(samples.pop)],
      'not the window on top of AW',
    ],
    ['a part of no window', 'warnock', part ? [part] : [], 'a part of no window'],
    [
      'the first window without list',
      'warnock',
      [{ e: 'push', at: 'W3', window: [0, 0, 8, 8] }],
      'only the first window has a list',
    ],
    [
      'a part with a list',
      'warnock',
      [...started, { ...first(samples.push), at: 'W13' }],
      'only the first window has a list',
    ],
    [
      'an unknown polygon',
      'warnock',
      [...started, { e: 'discard', at: 'PW3', polygon: 'X' }],
      'not a polygon of the scene',
    ],
    [
      'an unknown polygon in the list',
      'warnock',
      [{ ...first(samples.push), apl: [['X', true]] }],
      'not a polygon of the scene',
    ],
    [
      'a discard of what is not there',
      'warnock',
      [...started, { e: 'discard', at: 'PW3', polygon: 'B' }],
      'a polygon that is not in the current APL',
    ],
    [
      'nearer without depths',
      'warnock',
      [...started, first(samples.corners), ...samples.nearer.slice(1, 2)],
      'not preceded by four depths',
    ],
    [
      'a fill off the area',
      'warnock',
      [{ e: 'fill', at: 'W7', rect: [4, 4, 5, 1], color: '#ffffff' }],
      'a rectangle outside the area',
    ],
    [
      'a fill turned round',
      'warnock',
      [{ e: 'fill', at: 'W7', rect: [4, 4, -1, 1], color: '#ffffff' }],
      'a rectangle outside the area',
    ],
    [
      'a result without call',
      'warnock',
      [first(samples.summary)],
      'a result of a procedure that is not running',
    ],
    ['a vertex without clip', 'warnock', [first(samples.clip_keep)], 'nothing is being clipped'],
    [
      'a wrong count of vertices',
      'warnock',
      [first(samples.clip_begin), ...samples.clip_list.slice(1)],
      'a list of another length',
    ],
    [
      'a span without polygon',
      'zbuffer',
      [{ e: 'call', at: 'Z14', of: 'ShowLine' }, first(samples.span)],
      'a span of no polygon',
    ],
    [
      'depths for other pixels',
      'zbuffer',
      [polygon, { e: 'call', at: 'Z14', of: 'ShowLine' }, { ...first(samples.span), depths: [1] }],
      'not one depth for each pixel',
    ],
    [
      'an edge that is not in S',
      'zbuffer',
      [polygon, ...samples.leave.slice(1, 2)],
      'an edge that is not in S',
    ],
    [
      'an edge that is not in AEL',
      'zbuffer',
      [polygon, first(samples.ael_step)],
      'an edge that is not in AEL',
    ],
    ['an edge twice', 'zbuffer', [polygon, added, added], 'an edge that is already in AEL'],
    [
      'an order of others',
      'zbuffer',
      [polygon, added, ...samples.ael_sort.slice(1)],
      'an edge that is not in AEL',
    ],
  ];

describe('an event that cannot happen is refused', () => {
  it.each(impossible)('%s', async (_name, method, events, reason) => {
    const before: Event = { e: 'plane', at: 'I1', polygon: 'A', plane: [0, 0, 1, 0] };
    const { shortened } = await keptOf(textWith(headerOf(method), [before, ...events]));
    expect(shortened).toMatchObject({ why: 'wrong', line: events.length + 2, reason });
  });
});
