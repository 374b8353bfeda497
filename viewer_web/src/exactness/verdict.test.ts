import { expect, it } from 'vitest';
import { headerOf, textWith, traceOf } from '../testing/traces.js';
import { isAlwaysRight } from '../trace/editions.js';
import type { Event } from '../trace/events.js';
import { isWrong, verdictOf } from './verdict.js';

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

it('a wrong decision and the step that reports it have the same verdict', async () => {
  const trace = await traceOf(textWith(headerOf('warnock'), [orient, disagree]));
  const verdict = verdictOf(trace, 1);
  expect(verdict).toEqual({
    of: 'orientation',
    numbers: [['f', -1e-17]],
    taken: -1,
    exact: 0,
    by: undefined,
    operands: undefined,
    cause: 'rounded',
  });
  expect(verdictOf(trace, 2)).toEqual(verdict);
  expect(verdict && isWrong(verdict)).toBe(true);
});

it('a step without events of its decisions has the verdict of the first wrong one', async () => {
  const piece: Event = { e: 'edge_piece', at: 'RC2', from: [0, 3], to: [1, 2], lies: 'outside' };
  const left: Event = { ...disagree, at: 'RC2', of: 'left_of', taken: true, exact: false };
  const trace = await traceOf(
    textWith(headerOf('weiler-atherton'), [piece, left, disagree, piece]),
  );
  expect(verdictOf(trace, 1)).toMatchObject({ of: 'left_of', numbers: [], taken: true });
  expect(verdictOf(trace, 1)).toEqual(verdictOf(trace, 2));
  expect(verdictOf(trace, 3)?.of).toBe('orientation');
  expect(verdictOf(trace, 4)).toBeNull();
});

it('ranges are compared as a whole', async () => {
  const row = { e: 'row', at: 'F2', row: 1, left: 0.5, right: 2.5, first: 0, end: 3 } as const;
  const wrong = async (exact: readonly [number, number]): Promise<boolean> => {
    const trace = await traceOf(textWith(headerOf('warnock'), [{ ...row, exact }]));
    const verdict = verdictOf(trace, 1);
    return verdict !== null && isWrong(verdict);
  };
  expect(await wrong([0, 3])).toBe(false);
  expect(await wrong([0, 2])).toBe(true);
});

it('an answer is wrong only if it is known to be', async () => {
  const { exact, ...unchecked } = orient;
  expect(exact).toBe(0);
  const trace = await traceOf(
    textWith(headerOf('warnock'), [unchecked, { ...orient, exact: null }]),
  );
  for (const step of [1, 2]) {
    const verdict = verdictOf(trace, step);
    expect(verdict && isWrong(verdict)).toBe(false);
  }
});

it('a step without a numerical decision has none', async () => {
  const trace = await traceOf(textWith(headerOf('zbuffer'), [clear]));
  expect(verdictOf(trace, 0)).toBeNull();
  expect(verdictOf(trace, 1)).toBeNull();
});

it('three kernels always decide as exact arithmetic does, even unchecked', () => {
  const kernels = ['float', 'double', 'bits:8', 'depth:16', 'grid:4', 'filtered', 'exact'];
  expect(kernels.filter(isAlwaysRight)).toEqual(['grid:4', 'filtered', 'exact']);
});
