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

it('runs no usual mistake: the corrected text is run instead', () => {
  expect(count({ edition: 'one-list' })).toBe(0);
  const exact = { ...usual, kernel: 'exact' };
  expect(runnable({ ...exact, edition: 'one-list' })).toEqual(exact);
});

it('runs a variant of the corrected text alone', () => {
  expect(count({ method: 'warnock-full' })).toBe(8); // no depth:8, depth:16
  expect(count({ method: 'warnock-full', edition: 'printed' })).toBe(0);
  const asked = { ...usual, method: 'warnock-full', edition: 'printed', check: true } as const;
  expect(runnable({ ...asked, kernel: 'exact' })).toEqual({
    ...asked,
    edition: 'corrected',
    kernel: 'exact',
  });
  expect(runnable({ ...asked, kernel: 'depth:8' }).kernel).toBe('double');
});

it('goes back to double where the kernel does not run', () => {
  expect(runnable({ ...usual, kernel: 'filtered', edition: 'printed' }).kernel).toBe('double');
  expect(runnable({ ...usual, kernel: 'exact', edition: 'printed' }).kernel).toBe('exact');
});
