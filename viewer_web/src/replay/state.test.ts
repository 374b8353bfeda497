import { describe, expect, it } from 'vitest';
import { samples } from '../testing/samples.js';
import { headerOf, textOf, textWith, traceNames, traceOf, pop, push } from '../testing/traces.js';
import type { Event } from '../trace/events.js';
import type { Reason } from '../trace/refusal.js';
import { canonical } from './canonical.js';
import { Lines } from './lines.js';
import { State } from './state.js';
import { Unreadable } from './trace.js';
import type { Trace } from './trace.js';

const stateAt = ({ header, timeline }: Trace, step: number): unknown =>
  structuredClone(canonical(timeline.seek(step), header, timeline.lines.at(step)));

/** The states after each event in order, without keyframes. */
function statesOf({ header, timeline }: Trace): readonly unknown[] {
  const state = new State(header);
  const canonicalNow = (step: number): unknown =>
    structuredClone(canonical(state, header, new Lines(timeline).at(step)));
  const states: unknown[] = [canonicalNow(0)];
  for (let step = 1; step <= timeline.length; step++) {
    const event = timeline.event(step);
    if (event) state.apply(event);
    states.push(canonicalNow(step));
  }
  return states;
}

describe('a seek gives the same state as all events in order', () => {
  it.each(traceNames)('%s, forward, backward and far', async (name) => {
    const trace = await traceOf(textOf(name));
    const states = statesOf(trace);
    const { length } = trace.timeline;
    for (let step = length; step >= 0; step--) expect(stateAt(trace, step)).toEqual(states[step]);
    for (let step = 0; step <= length; step++) expect(stateAt(trace, step)).toEqual(states[step]);
    for (let i = 0; i < 50; i++) {
      const step = (i * 7919) % (length + 1);
      expect(stateAt(trace, step)).toEqual(states[step]);
    }
  });
});

describe('both methods paint the same picture', () => {
  it.each(['windows', 'polygons', 'signs'])('at level %s', async (detail) => {
    const pictures = await Promise.all(
      ['warnock', 'zbuffer'].map(async (method) => {
        const trace = await traceOf(textOf(`small.${method}.${detail}.jsonl`));
        const { picture } = stateAt(trace, trace.timeline.length) as { picture: unknown };
        return picture;
      }),
    );
    expect(pictures[0]).toEqual(pictures[1]);
  });
});

describe('a list of active polygons', () => {
  const discard: Event = { e: 'discard', at: 'PW3', polygon: 'A' };

  async function stackAfter(part: Event): Promise<unknown> {
    const trace = await traceOf(textWith(headerOf('warnock'), [push, pop, part, discard]));
    return stateAt(trace, 4);
  }

  it('is copied for a part of the window', async () => {
    const state = await stackAfter({ e: 'push', at: 'W13', window: [0, 0, 4, 4] });
    expect(state).toMatchObject({
      warnock: {
        apl: [['B', false]],
        stack: [
          {
            apl: [
              ['A', false],
              ['B', false],
            ],
          },
        ],
      },
    });
  });

  it('is the same for both windows if it is shared', async () => {
    const state = await stackAfter({ e: 'push', at: 'W13', window: [0, 0, 4, 4], shared: true });
    expect(state).toMatchObject({
      warnock: { apl: [['B', false]], stack: [{ apl: [['B', false]] }] },
    });
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

const impossible: readonly (readonly [string, 'warnock' | 'zbuffer', readonly Event[], Reason])[] =
  [
    ['pop of nothing', 'warnock', [popped], 'emptyStack'],
    ['pop of another window', 'warnock', [first(samples.push), first(samples.pop)], 'notTop'],
    ['a part of no window', 'warnock', part ? [part] : [], 'noWindow'],
    [
      'the first window without list',
      'warnock',
      [{ e: 'push', at: 'W3', window: [0, 0, 8, 8] }],
      'rootNeedsList',
    ],
    [
      'a part with a list',
      'warnock',
      [...started, { ...first(samples.push), at: 'W13' }],
      'partHasList',
    ],
    [
      'an unknown polygon',
      'warnock',
      [...started, { e: 'discard', at: 'PW3', polygon: 'X' }],
      'noSuchPolygon',
    ],
    [
      'an unknown polygon in the list',
      'warnock',
      [{ ...first(samples.push), apl: [['X', true]] }],
      'noSuchPolygon',
    ],
    [
      'a discard of what is not there',
      'warnock',
      [...started, { e: 'discard', at: 'PW3', polygon: 'B' }],
      'notInList',
    ],
    [
      'nearer without depths',
      'warnock',
      [...started, first(samples.corners), ...samples.nearer.slice(1, 2)],
      'noDepths',
    ],
    [
      'a fill off the area',
      'warnock',
      [{ e: 'fill', at: 'W7', rect: [4, 4, 5, 1], color: '#ffffff' }],
      'outsideArea',
    ],
    [
      'a fill turned round',
      'warnock',
      [{ e: 'fill', at: 'W7', rect: [4, 4, -1, 1], color: '#ffffff' }],
      'outsideArea',
    ],
    ['a result without call', 'warnock', [first(samples.summary)], 'resultOf'],
    ['a vertex without clip', 'warnock', [first(samples.clip_keep)], 'noClip'],
    [
      'a wrong count of vertices',
      'warnock',
      [first(samples.clip_begin), ...samples.clip_list.slice(1)],
      'clipCount',
    ],
    [
      'a span without polygon',
      'zbuffer',
      [{ e: 'call', at: 'Z14', of: 'ShowLine' }, first(samples.span)],
      'noPolygon',
    ],
    [
      'depths for other pixels',
      'zbuffer',
      [polygon, { e: 'call', at: 'Z14', of: 'ShowLine' }, { ...first(samples.span), depths: [1] }],
      'depthCount',
    ],
    ['an edge that is not in S', 'zbuffer', [polygon, ...samples.leave.slice(1, 2)], 'notInS'],
    ['an edge that is not in AEL', 'zbuffer', [polygon, first(samples.ael_step)], 'notInAel'],
    ['an edge twice', 'zbuffer', [polygon, added, added], 'twiceInAel'],
    ['an order of others', 'zbuffer', [polygon, added, ...samples.ael_sort.slice(1)], 'notAnOrder'],
  ];

describe('an event that cannot happen is refused', () => {
  it.each(impossible)('%s', async (_name, method, events, reason) => {
    const error: unknown = await traceOf(textWith(headerOf(method), events)).catch(
      (thrown: unknown) => thrown,
    );
    expect(error).toBeInstanceOf(Unreadable);
    expect((error as Unreadable).refusal.reason).toBe(reason);
    expect((error as Unreadable).line).toBe(events.length + 1);
  });
});
