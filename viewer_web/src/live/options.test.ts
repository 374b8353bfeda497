import { expect, it } from 'vitest';
import { kernels, runnable, runs, usual } from './options.js';
import type { Options } from './options.js';

const count = (given: Partial<Options>): number =>
  kernels.filter((kernel) => runs({ ...usual, ...given, kernel })).length;

it('leaves out the kernels that have no Z-buffer, and those that never err, of the printed text', () => {
  expect(kernels).toHaveLength(10);
  expect(count({ method: 'zbuffer' })).toBe(10);
  expect(count({ method: 'warnock' })).toBe(8); // no depth:8, depth:16
  expect(count({ method: 'warnock', edition: 'printed' })).toBe(5); // nor filtered, grid:4, grid:8
});

it('runs a usual mistake where it can be made, under double and exact', () => {
  expect(count({ method: 'warnock', edition: 'one-list' })).toBe(2);
  expect(count({ method: 'zbuffer', edition: 'one-list' })).toBe(0);
  expect(count({ method: 'zbuffer', edition: 'y-flipped' })).toBe(2);
});

it('goes back to the corrected text where the method cannot have the mistake', () => {
  const runs = { ...usual, method: 'zbuffer', edition: 'one-list', kernel: 'filtered' } as const;
  expect(runnable(runs)).toEqual({ ...runs, edition: 'corrected' });
  expect(runnable({ ...runs, edition: 'y-flipped' })).toMatchObject({
    edition: 'y-flipped',
    kernel: 'double',
  });
});

it('goes back to double where the kernel does not run', () => {
  expect(runnable({ ...usual, kernel: 'filtered', edition: 'printed' }).kernel).toBe('double');
  expect(runnable({ ...usual, kernel: 'exact', edition: 'printed' }).kernel).toBe('exact');
});
