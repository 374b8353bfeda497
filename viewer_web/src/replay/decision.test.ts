import { expect, it } from 'vitest';
import { headerOf, textWith, traceOf } from '../testing/traces.js';
import { isAlwaysRight } from '../trace/editions.js';
import type { Event } from '../trace/events.js';
import type { Trace } from './trace.js';

const decisionAt = ({ timeline }: Trace, step: number) => timeline.decision(step, 'en');

const orient: Event = {
  e: 'orient',
  at: 'S3',
  polygon: 'A',
  edge: 0,
  point: [4, 0],
  value: -1e-17,
  sign: -1,
  exact: 0,
};
const disagree: Event = {
  e: 'disagree',
  at: 'S3',
  of: 'orientation',
  taken: -1,
  exact: 0,
  cause: 'rounded',
};
const clear: Event = { e: 'clear', at: 'Z1', color: '#ffffff', z: '-inf' };

it('a wrong decision and the step that reports it are one', async () => {
  const trace = await traceOf(textWith(headerOf('warnock'), [orient, disagree]));
  const decision = decisionAt(trace, 1);
  expect(decision).toEqual({
    of: 'orientation',
    taken: -1,
    title: 'On which side of the line the point lies',
    numbers: [['f', '−1e−17']],
    answers: [
      ['Computed', 'negative'],
      ['Exactly', 'zero'],
    ],
    judged: 'wrong',
    judgement: '✗ Wrong. This operation rounded.',
    calculations: [],
  });
  expect(decisionAt(trace, 2)).toEqual(decision);
});

it('a step without events of its decisions has the first wrong one', async () => {
  const piece: Event = { e: 'edge_piece', at: 'RC2', from: [0, 3], to: [1, 2], lies: 'outside' };
  const left: Event = { ...disagree, at: 'RC2', of: 'left_of', taken: true, exact: false };
  const trace = await traceOf(
    textWith(headerOf('weiler-atherton'), [piece, left, disagree, piece]),
  );
  expect(decisionAt(trace, 1)).toMatchObject({ of: 'left_of', numbers: [], taken: true });
  expect(decisionAt(trace, 1)).toEqual(decisionAt(trace, 2));
  expect(decisionAt(trace, 3)?.of).toBe('orientation');
  expect(decisionAt(trace, 4)).toBeNull();
});

it('ranges are compared as a whole', async () => {
  const row = { e: 'row', at: 'F2', row: 1, left: 0.5, right: 2.5, first: 0, end: 3 } as const;
  const judged = async (exact: readonly [number, number]): Promise<string | undefined> => {
    const trace = await traceOf(textWith(headerOf('warnock'), [{ ...row, exact }]));
    return decisionAt(trace, 1)?.judged;
  };
  expect(await judged([0, 3])).toBe('right');
  expect(await judged([0, 2])).toBe('wrong');
});

it('an answer is wrong only if it is known to be', async () => {
  const { exact, ...unchecked } = orient;
  expect(exact).toBe(0);
  const trace = await traceOf(
    textWith(headerOf('warnock'), [unchecked, { ...orient, exact: null }]),
  );
  expect(decisionAt(trace, 1)?.judged).toBe('not_checked');
  expect(decisionAt(trace, 2)?.judged).toBe('undefined');
});

it('a step without a numerical decision has none', async () => {
  const trace = await traceOf(textWith(headerOf('zbuffer'), [clear]));
  expect(decisionAt(trace, 0)).toBeNull();
  expect(decisionAt(trace, 1)).toBeNull();
});

it('three kernels always decide as exact arithmetic does, even unchecked', () => {
  const kernels = ['float', 'double', 'bits:8', 'depth:16', 'grid:4', 'filtered', 'exact'];
  expect(kernels.filter(isAlwaysRight)).toEqual(['grid:4', 'filtered', 'exact']);
});
