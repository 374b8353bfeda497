import { expect, it } from 'vitest';
import { editions } from '../trace/editions.js';
import { methods } from '../trace/events.js';
import { kernels, offeredNames, runnable, runs, usual } from './options.js';
import type { Options } from './options.js';
import { optionsOf, wordOf } from './packed.js';

const count = (given: Partial<Options>): number =>
  kernels.filter((kernel) => runs({ ...usual, ...given, kernel })).length;

it('leaves out the kernels that have no Z-buffer, and those that never err, of the printed text', () => {
  expect(kernels).toHaveLength(10);
  expect(count({ method: 'zbuffer' })).toBe(10);
  expect(count({ method: 'warnock' })).toBe(8); // no depth:8, depth:16
  expect(count({ method: 'warnock', edition: 'printed' })).toBe(5); // nor filtered, grid:4, grid:8
});

const mistakes = [
  ['one-list', ['warnock']],
  ['depths-not-cleared', ['zbuffer']],
  ['clip-order-reversed', ['warnock']],
  ['y-flipped', ['warnock', 'zbuffer']],
  ['depth-sign-reversed', ['warnock', 'zbuffer']],
  ['boundary-outside', ['warnock', 'zbuffer']],
  ['integer-division', ['warnock']],
  ['surround-kept', ['warnock']],
  ['vertex-counted-twice', ['warnock-full']],
  ['octants-not-split', ['warnock-angles']],
  ['line-for-edge', ['warnock-full']],
] as const;

it('runs a usual mistake in the methods that can make it, in double and exact numbers', () => {
  expect(['corrected', 'printed', ...mistakes.map(([edition]) => edition)]).toEqual(editions);
  for (const [edition, expected] of mistakes) {
    const ways = methods.flatMap((method) =>
      kernels.filter((kernel) => runs({ method, edition, kernel })).map((each) => [method, each]),
    );
    const numbers = ['double', 'exact'];
    expect(ways).toEqual(expected.flatMap((method) => numbers.map((each) => [method, each])));
  }
});

it('offers the editions that a method has', () => {
  const names = Object.fromEntries(editions.map((edition) => [edition, edition]));
  const offered = (method: Options['method']): readonly string[] =>
    Object.keys(offeredNames(method, names as Parameters<typeof offeredNames>[1]));
  expect(offered('warnock')).toEqual([
    ...['corrected', 'printed', 'one-list', 'clip-order-reversed', 'y-flipped'],
    ...['depth-sign-reversed', 'boundary-outside', 'integer-division', 'surround-kept'],
  ]);
  expect(offered('zbuffer')).toEqual([
    ...['corrected', 'printed', 'depths-not-cleared', 'y-flipped'],
    ...['depth-sign-reversed', 'boundary-outside'],
  ]);
  expect(offered('warnock-full')).toEqual(['corrected', 'vertex-counted-twice', 'line-for-edge']);
  expect(offered('warnock-angles')).toEqual(['corrected', 'octants-not-split']);
  expect(offered('weiler-atherton')).toEqual(['corrected']);
  expect(offered('floating-horizon')).toEqual(['corrected', 'printed']);
});

it('keeps a usual mistake, in double numbers, while the method can make it', () => {
  const kept = { ...usual, edition: 'boundary-outside', check: true } as const;
  expect(runnable({ ...kept, kernel: 'exact' }).kernel).toBe('exact');
  expect(runnable({ ...kept, kernel: 'float' })).toEqual(kept);
  expect(runnable({ ...kept, kernel: 'depth:8', method: 'zbuffer' })).toEqual({
    ...kept,
    method: 'zbuffer',
  });
  const given = { ...kept, method: 'warnock-full' } as const;
  expect(runnable({ ...given, kernel: 'exact' })).toEqual({
    ...given,
    edition: 'corrected',
    kernel: 'exact',
  });
});

it('comes through an address', () => {
  const mistaken: Options = { ...usual, edition: 'surround-kept', kernel: 'exact', check: true };
  expect(optionsOf(wordOf(mistaken))).toEqual(mistaken);
  expect(optionsOf('zbuffer.surround-kept.exact.signs.check')).toEqual({
    ...mistaken,
    method: 'zbuffer',
    edition: 'corrected',
  });
  expect(optionsOf('warnock.of-somebody.exact.signs.check').edition).toBe('corrected');
});

it('runs no printed text of a variant', () => {
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
