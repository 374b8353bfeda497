import { describe, expect, it } from 'vitest';
import { headerOf, textWith, traceOf } from '../testing/traces.js';
import type { Event } from '../trace/events.js';
import type { Trace } from '../replay/trace.js';
import { Comparison } from './comparison.js';

const trace = (events: readonly Event[], header = headerOf('warnock')): Promise<Trace> =>
  traceOf(textWith(header, events));

async function compared(one: Promise<Trace>, other: Promise<Trace>): Promise<Comparison> {
  const comparison = new Comparison(await one, await other);
  while (!comparison.read());
  return comparison;
}

const push: Event = { e: 'push', at: 'W3', window: [0, 0, 8, 8], apl: [['A', false]] };
const pop: Event = { e: 'pop', at: 'W5', window: [0, 0, 8, 8] };
const corners = (z: number): Event => ({ e: 'corners', at: 'PW1', z });
const call: Event = { e: 'call', at: 'W6', of: 'ProcessWindow' };
const count: Event = { e: 'count', at: 'PW4', polygon: 'A', count: 1 };
const summary: Event = {
  e: 'summary',
  at: 'W6',
  count: 1,
  hasSurround: false,
  insider: false,
};
const decide: Event = { e: 'decide', at: 'W10', case: 'single' };
const fill: Event = { e: 'fill', at: 'W10', rect: [0, 0, 8, 8], color: '#112233' };
const insider = (inside: boolean, exact?: boolean): Event => ({
  e: 'insider',
  at: 'PW10',
  polygon: 'A',
  inside,
  ...(exact === undefined ? {} : { exact }),
});

describe('two runs diverge', () => {
  it('first in a number, then in an action', async () => {
    const { parting } = await compared(
      trace([push, pop, call, corners(0), count, summary, decide]),
      trace([push, pop, call, corners(-1), count, insider(true), summary, decide]),
    );
    // Step 4 has another depth, and step 6 is another event.
    expect(parting).toMatchObject({ text: [4, 4], deed: [6, 6] });
  });

  it('nowhere, if they are the same', async () => {
    const events = [push, pop, call, corners(0)];
    const { parting } = await compared(trace(events), trace(events));
    expect(parting).toMatchObject({ text: null, deed: null, complete: true });
  });

  it('where one of them ends', async () => {
    const { parting } = await compared(trace([push, pop, call]), trace([push, pop]));
    expect(parting).toMatchObject({ text: [3, 2], deed: [3, 2] });
  });

  it('in an action, not where one of them is checked or less detailed', async () => {
    const wrong: Event = {
      e: 'disagree',
      at: 'PW10',
      of: 'inside',
      taken: true,
      exact: false,
      cause: 'rounded',
    };
    const { parting } = await compared(
      trace([push, pop, call, insider(true, false), wrong, summary, decide]),
      trace([push, pop, decide], headerOf('warnock', 'windows')),
    );
    // The coarse run lacks step 3; both decide the same.
    expect(parting).toMatchObject({ text: [3, 3], deed: null });
  });

  it('nowhere, if one of them only lacks the calls of tests', async () => {
    const surround: Event = { e: 'surround', at: 'PW8', polygon: 'A', point: [0, 0], inside: true };
    const test: Event = { e: 'call', at: 'PW8', of: 'SurroundTest' };
    const { parting } = await compared(
      trace([push, pop, call, test, surround, summary]),
      trace([push, pop, call, surround, summary], headerOf('warnock', 'polygons')),
    );
    expect(parting).toMatchObject({ text: [4, 4], deed: null });
  });

  it('at no common step, if their methods differ', async () => {
    const zbuffer = trace([{ e: 'clear', at: 'Z1', color: '#ffffff', z: 0 }], headerOf('zbuffer'));
    const comparison = await compared(trace([push, pop]), zbuffer);
    expect(comparison.parting).toBeNull();
    expect(comparison.alignment).toBe('byShare');
    // Half of two steps is half of one step, rounded up.
    expect([0, 1, 2].map((step) => comparison.paired(step))).toEqual([0, 1, 1]);
  });
});

describe('two runs are stepped together', () => {
  it('by the same window and its decision; the run that arrives first waits', async () => {
    const fine = [push, pop, call, corners(0), count, summary, decide, fill];
    const coarse = [push, pop, decide, fill];
    const comparison = await compared(trace(fine), trace(coarse, headerOf('warnock', 'windows')));
    const steps = fine.map((_, i) => comparison.paired(i + 1));
    // push, pop; the window is decided in step 7 of one run and in step 3 of the other.
    expect(steps).toEqual([1, 2, 2, 2, 2, 2, 3, 4]);
  });
});

describe('two runs without a common window', () => {
  it('are stepped together up to the first difference', async () => {
    const long = Array.from({ length: 8 }, () => corners(2));
    const comparison = await compared(
      trace([push, corners(0), count]),
      trace([push, corners(0), corners(1), ...long]),
    );
    expect(comparison.parting?.text).toEqual([3, 3]);
    expect(comparison.alignment).toBe('byShareAfter');
    expect([1, 2, 3].map((step) => comparison.paired(step))).toEqual([1, 2, 3]);
  });
});

describe('the counters', () => {
  it('count up to a step and to the end, and are empty for events that the trace lacks', async () => {
    const split: Event = { e: 'decide', at: 'W13', case: 'split' };
    const part = (x: number, y: number): Event => ({ e: 'push', at: 'W13', window: [x, y, 4, 4] });
    const square: Event = { e: 'fill', at: 'W8', rect: [4, 4, 4, 4], color: '#112233' };
    const events = [push, pop, split, part(0, 0), part(4, 0), part(0, 4), part(4, 4)];
    const next: Event = { e: 'pop', at: 'W5', window: [4, 4, 4, 4] };
    const windows = headerOf('warnock', 'windows');
    const one = trace([...events, next, square], windows);
    const comparison = await compared(one, trace([push, pop, decide, fill], windows));
    const [all, other] = comparison.counts();
    expect(all).toEqual({
      windows: 2,
      splits: 1,
      surrounds: null,
      relations: null,
      comparisons: null,
      sides: null,
      ael: null,
      painted: 16,
      lists: null,
      clips: null,
      regions: null,
      curves: null,
      flags: null,
      crossings: null,
      lines: null,
      wrong: null,
      steps: 9,
    });
    expect(other).toMatchObject({ windows: 1, splits: 0, painted: 64, steps: 4 });
    const [sofar] = comparison.counts([2, 0]);
    expect(sofar).toMatchObject({ windows: 1, splits: 0, painted: 0, steps: 2 });
    // All 8 x 8 pixels have the colour in one run, 4 x 4 in the other.
    expect(comparison.differsAtEnd).toBe(48);
  });
});
