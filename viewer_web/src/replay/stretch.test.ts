import { describe, expect, it } from 'vitest';
import { chance } from '../testing/chance.js';
import { samples } from '../testing/samples.js';
import { bareTimelineOf, headerOf, textOf, textWith, traceNames } from '../testing/traces.js';
import { eventsOf } from '../trace/events.js';
import type { Event, Method } from '../trace/events.js';
import { parseHeader } from '../trace/header.js';
import { isRefusal } from '../trace/refusal.js';
import { State } from './state.js';
import type { Keyframe } from './state.js';
import type { Timeline } from './timeline.js';

const copyOf = (state: State): Keyframe => structuredClone(state.save());

/** The states after each event in order, from step 0. */
function statesInTurn(header: unknown, events: readonly Event[]): readonly Keyframe[] {
  const state = new State(parseHeader(header));
  return [copyOf(state), ...events.map((event) => (state.apply(event), copyOf(state)))];
}

function expectStates(timeline: Timeline, expected: readonly Keyframe[], from: number[]): void {
  for (let step = 0; step <= timeline.length; step++) {
    timeline.seek(from[step % from.length] ?? 0);
    expect(copyOf(timeline.seek(step))).toEqual(expected[step]);
  }
}

/** Checks the values at each step while the state stays at others. */
function expectValues(timeline: Timeline, expected: readonly Keyframe[], from: number[]): void {
  for (let step = 0; step <= timeline.length; step++) {
    const stays = from[step % from.length] ?? 0;
    const state = timeline.seek(stays);
    expect(timeline.valuesAt(step)).toEqual(expected[step]?.values);
    expect(copyOf(state)).toEqual(expected[stays]);
  }
}

describe('the relevant events of a stretch give the same state as all its events, without keyframes', () => {
  it.each(traceNames)(
    '%s, from the beginning to each step',
    async (name) => {
      const [header = '', ...lines] = textOf(name).trim().split('\n').slice(0, -1);
      const events = lines.map((line) => JSON.parse(line) as Event);
      const states = statesInTurn(JSON.parse(header), events);
      expectStates(await bareTimelineOf(textOf(name)), states, [0]);
      expectValues(await bareTimelineOf(textOf(name)), states, [0, events.length]);
    },
    60_000,
  );

  const seeds = [1, 2, 3, 4, 5, 6, 7, 8];
  const runs = seeds.flatMap((seed) => [['warnock', seed] as const, ['zbuffer', seed] as const]);

  it.each(runs)('events in any order, %s %i, from any step', async (method, seed) => {
    const events = anyEvents(method, 120, seed);
    const header = headerOf(method);
    const states = statesInTurn(header, events);
    const text = textWith(header, events);
    expectStates(await bareTimelineOf(text), states, [0, 20, 77, 110]);
    expectValues(await bareTimelineOf(text), states, [0, 20, 77, 110]);
  });
});

/** Random events in an order that is possible, although no run would write it. */
function anyEvents(method: Method, length: number, seed: number): readonly Event[] {
  const below = chance(seed);
  const names = eventsOf[method];
  const state = new State(parseHeader(headerOf(method)));
  const events: Event[] = [];
  while (events.length < length) {
    const kind = samples[names[below(names.length)] ?? 'plane'];
    const event = possible(kind[below(kind.length)] ?? samples.plane[0], state);
    if (event !== undefined && isTaken(event, state)) events.push(event);
  }
  return events;
}

/** Makes an event possible: what it removes must exist. */
function possible(event: Event | undefined, { values }: State): Event | undefined {
  const top = values.warnock?.stack.at(-1);
  if (event?.e === 'pop' && top !== undefined) return { ...event, window: top.window };
  if (event?.e === 'clip_list' && values.warnock?.clip) {
    return { ...event, count: values.warnock.clip.next.length };
  }
  if (event?.e === 'ael_sort') {
    return { ...event, edges: values.zbuffer?.ael.map(({ edge }) => edge).reverse() ?? [] };
  }
  return event;
}

function isTaken(event: Event, state: State): boolean {
  const before = state.save();
  try {
    state.apply(event);
    return true;
  } catch (refusal) {
    if (!isRefusal(refusal)) throw refusal;
    state.load(before);
    return false;
  }
}
