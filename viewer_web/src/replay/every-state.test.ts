import { describe, expect, it } from 'vitest';
import { statesOf, traceIn, tracesWithStates } from '../testing/states.js';
import { traceOf } from '../testing/traces.js';
import { canonical } from './canonical.js';

/** Milliseconds: the longest trace has 80 MB of states. */
const timeout = 60_000;

const withStates = describe.runIf(tracesWithStates.length > 0);
withStates('every step is the state of the program', { timeout }, () => {
  it.each(tracesWithStates)('%s, forward and backward', async (name) => {
    const { header, timeline } = await traceOf(traceIn(name));
    const stateAt = (step: number): string =>
      JSON.stringify(canonical(timeline.seek(step), header, timeline.lines.at(step)));
    const expected = statesOf(name);
    expect(timeline.length).toBe(expected.length - 1);
    expect(expected.map((_, step) => stateAt(step))).toEqual(expected);
    const backward = [...expected.keys()].reverse();
    expect(backward.map(stateAt).reverse()).toEqual(expected);
  });
});
