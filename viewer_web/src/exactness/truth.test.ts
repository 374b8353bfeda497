import { describe, expect, it } from 'vitest';
import type { Trace } from '../replay/trace.js';
import { headerOf, pop, push, textWith, traceOf } from '../testing/traces.js';
import type { Event } from '../trace/events.js';
import { certaintyOf } from './certainty.js';
import { Truth, decisionBy } from './truth.js';

const orient = (value: number): Event<'orient'> => ({
  e: 'orient',
  at: 'S3',
  polygon: 'A',
  edge: 0,
  point: [4, 0],
  value,
  sign: value < 0 ? -1 : 1,
});
const disagree: Event = {
  e: 'disagree',
  at: 'S3',
  of: 'orientation',
  taken: -1,
  exact: 1,
  cause: 'rounded',
};
const trace = (...events: readonly Event[]): Promise<Trace> =>
  traceOf(textWith(headerOf('warnock'), events));

const unchecked = [push, pop, orient(1), orient(-2), orient(3)] as const;
const checked = [
  push,
  pop,
  { ...orient(1), exact: 1 },
  { ...orient(-2), exact: 1 },
  disagree,
  { ...orient(3), exact: 1 },
] as const;

describe('the right answers for an unchecked run', () => {
  it('are those of the same run with checks, at each step', async () => {
    const run = await trace(...unchecked);
    const truth = Truth.of(run, await trace(...checked));
    if (truth === null) throw new Error('another run');
    expect(truth.wrong).toEqual([4]);
    const judged = [1, 3, 4, 5].map(
      (step) => decisionBy({ is: 'found', truth }, run, step, 'en')?.judged,
    );
    expect(judged).toEqual([undefined, 'right', 'wrong', 'right']);
    expect(decisionBy({ is: 'unchecked' }, run, 4, 'en')?.judged).toBe('not_checked');
  });

  it('are never those of another run', async () => {
    const other = await trace(...checked);
    expect(Truth.of(await trace(push, pop, orient(1), orient(-2), orient(4)), other)).toBeNull();
    expect(Truth.of(await trace(...unchecked, orient(5)), other)).toBeNull();
    // A truncated run is the beginning of the whole one.
    expect(Truth.of(await trace(push, pop, orient(1)), other)?.wrong).toEqual([]);
  });

  it('do not depend on the format of the trace', async () => {
    const spaced = textWith(headerOf('warnock'), unchecked).replaceAll('"sign":', '"sign": ');
    expect(Truth.of(await traceOf(spaced), await trace(...checked))?.wrong).toEqual([4]);
  });
});

describe('what a trace reveals about its decisions', () => {
  it.each([
    ['unchecked', 'double', unchecked],
    ['checked', 'double', checked],
    // Traces of level `windows` have wrong decisions, but no right ones.
    ['checked', 'double', [push, pop, disagree]],
    ['unchecked', 'double', [push, pop]],
    ['certain', 'exact', unchecked],
    ['checked', 'exact', checked],
  ] as const)('%s, under %s', async (certainty, kernel, events) => {
    const header = { ...headerOf('warnock'), kernel };
    expect(certaintyOf(await traceOf(textWith(header, events)))).toBe(certainty);
  });
});
