import { describe, expect, it } from 'vitest';
import { chance } from '../testing/chance.js';
import { samples } from '../testing/samples.js';
import { headerOf, keptOf, pop, push, textWith } from '../testing/traces.js';
import { eventsOf, methods } from '../trace/events.js';
import type { Event, Method } from '../trace/events.js';
import { parseHeader } from '../trace/header.js';
import { isRefusal } from '../trace/refusal.js';
import type { Refusal } from '../trace/refusal.js';
import { State } from './state.js';

/** The index of the first event that a state refuses when the events are applied in order, and why. */
function refused(method: Method, events: readonly Event[]): readonly [number, Refusal] | null {
  const state = new State(parseHeader(headerOf(method)));
  for (const [i, event] of events.entries()) {
    try {
      state.apply(event);
    } catch (error) {
      if (!isRefusal(error)) throw error;
      return [i, error];
    }
  }
  return null;
}

/** Events that a state accepts, followed by one that it refuses. */
function untilRefused(method: Method, seed: number): readonly Event[] {
  const below = chance(seed);
  const names = eventsOf[method];
  const tries = 40;
  const events: Event[] = [];
  for (let i = 0; i < tries; i++) {
    const kind = samples[names[below(names.length)] ?? 'call'];
    const event = kind[below(kind.length)];
    if (event === undefined) continue;
    events.push(event);
    // Most impossible events are left out: a run that ends at once tests little.
    if (refused(method, events) === null) continue;
    if (i > tries / 2) return events;
    events.pop();
  }
  return events;
}

describe('an impossible event is refused where a state would refuse it', () => {
  const seeds = Array.from({ length: 12 }, (_, i) => i + 1);

  it.each(methods)('%s', async (method) => {
    const found = new Set<string>();
    for (const seed of seeds) {
      const events = untilRefused(method, seed);
      const expected = refused(method, events);
      if (expected === null) continue;
      const [index, { path, reason, details }] = expected;
      found.add(reason);
      if (index === 0) continue;
      const { shortened, timeline } = await keptOf(textWith(headerOf(method), events));
      expect(shortened).toMatchObject({ why: 'wrong', refusal: { path, reason, details } });
      expect(timeline.length).toBe(index);
    }
    expect(found.size).toBeGreaterThan(1);
  });

  it('in a window that is not cut along pixels, or extends beyond the area', async () => {
    const header = headerOf('warnock-vertex');
    for (const window of [
      [0, 0, 9, 8],
      [0.5, 0, 4, 8],
    ] as const) {
      const cut: Event = { e: 'push', at: 'WF1', window, apl: [['A', false]] };
      const { shortened } = await keptOf(textWith(header, [...samples.plane, cut]));
      expect(shortened).toMatchObject({ line: 3, refusal: { reason: 'outsideArea' } });
    }
  });

  it('even after events on which nothing depends', async () => {
    const idle = [...samples.cover, ...samples.insider, ...samples.decide, ...samples.uncover];
    const events = [push, pop, ...samples.corners, ...idle, ...samples.nearer.slice(1)];
    const { shortened } = await keptOf(textWith(headerOf('warnock'), events));
    expect(shortened).toMatchObject({ line: 5 + idle.length, refusal: { reason: 'noDepths' } });
  });
});
