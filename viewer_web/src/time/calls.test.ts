import { describe, expect, it } from 'vitest';
import { textOf, traceNames, traceOf } from '../testing/traces.js';
import { Calls } from './calls.js';

const callsIn = async (name: string): Promise<Calls> =>
  new Calls(await traceOf(textOf(`${name}.jsonl`)));

/** In this trace ProcessWindow is called at step 4 and returns at 23; SurroundTest is called at 18 and returns at 21. */
describe('in nested calls', () => {
  it('stepping goes over a procedure, and back over it', async () => {
    const calls = await callsIn('inside.warnock.signs');
    expect(calls.over(2, 1)).toBe(3);
    expect(calls.over(3, 1)).toBe(23);
    expect(calls.over(17, 1)).toBe(21);
    expect(calls.over(19, 1)).toBe(20);
    expect(calls.over(20, 1)).toBe(21);
    expect(calls.over(23, -1)).toBe(3);
    expect(calls.over(21, -1)).toBe(17);
    expect(calls.over(20, -1)).toBe(19);
    expect(calls.over(18, -1)).toBe(17);
  });

  it('stepping goes out of it, to its result or to the step before its call', async () => {
    const calls = await callsIn('inside.warnock.signs');
    expect(calls.out(19, 1)).toBe(21);
    expect(calls.out(21, 1)).toBe(23);
    expect(calls.out(10, 1)).toBe(23);
    expect(calls.out(19, -1)).toBe(17);
    expect(calls.out(17, -1)).toBe(3);
    expect(calls.out(10, -1)).toBe(3);
  });

  it('stepping out of the first procedure goes to the end or to the beginning', async () => {
    const calls = await callsIn('inside.warnock.signs');
    expect(calls.out(2, 1)).toBe(31);
    expect(calls.out(24, -1)).toBe(0);
    expect(calls.over(31, 1)).toBe(31);
    expect(calls.over(0, -1)).toBe(0);
  });
});

describe('less detail has fewer calls', () => {
  it('no SurroundTest among polygons', async () => {
    const calls = await callsIn('small.warnock.polygons');
    // ProcessWindow takes steps 5 to 25; surround at 14 does not end a call.
    expect(calls.over(4, 1)).toBe(25);
    expect(calls.over(13, 1)).toBe(14);
    expect(calls.out(14, 1)).toBe(25);
    expect(calls.out(14, -1)).toBe(4);
  });

  it('none at all among windows', async () => {
    const calls = await callsIn('small.warnock.windows');
    for (let step = 0; step < 115; step++) {
      expect(calls.over(step, 1)).toBe(step + 1);
      expect(calls.over(step + 1, -1)).toBe(step);
    }
  });
});

describe.each(traceNames)('%s', (name) => {
  it('ends with the call stacks of the state', async () => {
    const trace = await traceOf(textOf(name));
    const { timeline } = trace;
    const calls = new Calls(trace);
    const depth = (step: number): number => timeline.seek(step).values.calls.length;
    for (let step = 0; step < timeline.length; step++) {
      const over = calls.over(step, 1);
      expect(depth(over)).toBeLessThanOrEqual(depth(step));
      for (let between = step + 1; between < over; between++) {
        expect(depth(between)).toBeGreaterThan(depth(step));
      }
    }
  });
});
