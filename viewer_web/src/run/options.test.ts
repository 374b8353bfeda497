import { expect, it } from 'vitest';
import { editions, isMistake } from '../trace/editions.js';
import { methods } from '../trace/events.js';
import { kernels, offeredNames, runnable, runs, usual } from './options.js';
import type { Options } from './options.js';
import { optionsOf, wordOf } from './packed.js';

const missing = (given: Partial<Options>): readonly string[] =>
  kernels.filter((kernel) => !runs({ ...usual, ...given, kernel }));

it('leaves out, for the printed text, kernels without a Z-buffer and those that are always right', () => {
  expect(kernels).toHaveLength(10);
  expect(missing({ method: 'zbuffer' })).toEqual([]);
  expect(missing({ method: 'warnock' })).toEqual(['depth:8', 'depth:16']);
  expect(missing({ method: 'warnock', edition: 'printed' })).toEqual([
    'depth:8',
    'depth:16',
    'filtered',
    'grid:4',
    'grid:8',
  ]);
});

it('runs a usual mistake in the methods that can make it, in double and exact numbers', () => {
  const waysOf = (edition: Options['edition']): readonly (readonly string[])[] =>
    methods.flatMap((method) =>
      kernels.filter((kernel) => runs({ method, edition, kernel })).map((each) => [method, each]),
    );
  for (const edition of editions.filter(isMistake)) {
    const ways = waysOf(edition);
    const found = [...new Set(ways.map(([method]) => method))];
    expect(found).not.toEqual([]);
    expect(ways).toEqual(
      found.flatMap((method) => ['double', 'exact'].map((each) => [method, each])),
    );
  }
  const methodsOf = (edition: Options['edition']): readonly unknown[] => [
    ...new Set(waysOf(edition).map(([method]) => method)),
  ];
  expect(methodsOf('one-list')).toEqual(['warnock']);
  expect(methodsOf('y-flipped')).toEqual(['warnock', 'zbuffer']);
  expect(methodsOf('octants-not-split')).toEqual(['warnock-angles']);
});

it('offers the editions of a method', () => {
  const names = Object.fromEntries(editions.map((edition) => [edition, edition]));
  const offered = (method: Options['method']): readonly string[] =>
    Object.keys(
      offeredNames({ method, edition: 'corrected' }, names as Parameters<typeof offeredNames>[1]),
    );
  const always = ['corrected', 'printed'];
  expect(offered('warnock')).toEqual(expect.arrayContaining([...always, 'one-list', 'y-flipped']));
  expect(offered('warnock')).not.toContain('depths-not-cleared');
  expect(offered('zbuffer')).toEqual(
    expect.arrayContaining([...always, 'depths-not-cleared', 'y-flipped']),
  );
  expect(offered('zbuffer')).not.toContain('one-list');
  expect(offered('warnock-full')).toEqual(expect.arrayContaining(['corrected', 'line-for-edge']));
  expect(offered('warnock-full')).not.toContain('printed');
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

it('offers single defects of the printed text if they are chosen', () => {
  const names = Object.fromEntries(editions.map((edition) => [edition, edition]));
  const edition = 'printed:x-w2+x-w4';
  const offered = offeredNames(
    { method: 'warnock', edition },
    names as Parameters<typeof offeredNames>[1],
  );
  expect(offered[edition]).toBe('printed: X-W2, X-W4');
});

it('runs single defects under the kernels of the printed text, in the methods that have them', () => {
  expect(missing({ edition: 'printed:x-w2+x-w4' })).toEqual(missing({ edition: 'printed' }));
  expect(missing({ method: 'zbuffer', edition: 'printed:x-w2' })).toEqual(kernels);
  expect(missing({ method: 'zbuffer', edition: 'printed:x-w6+x-z5' })).not.toContain('depth:8');
  expect(runnable({ ...usual, edition: 'printed:x-w2', kernel: 'filtered' }).kernel).toBe('double');
  expect(runnable({ ...usual, edition: 'printed:x-z5' }).edition).toBe('corrected');
});

it('keeps single defects in an address', () => {
  const broken: Options = { ...usual, edition: 'printed:x-w2+x-w4', kernel: 'float' };
  expect(optionsOf(wordOf(broken))).toEqual(broken);
  for (const none of ['printed:', 'printed:x-w2+', 'printed:one-list', 'printed:x-z8']) {
    expect(optionsOf(`warnock.${none}.double.signs`).edition).toBe('corrected');
  }
});

it('is kept in an address', () => {
  const mistaken: Options = { ...usual, edition: 'surround-kept', kernel: 'exact', check: true };
  expect(optionsOf(wordOf(mistaken))).toEqual(mistaken);
  expect(optionsOf('zbuffer.surround-kept.exact.signs.check')).toEqual({
    ...mistaken,
    method: 'zbuffer',
    edition: 'corrected',
  });
  expect(optionsOf('warnock.of-somebody.exact.signs.check').edition).toBe('corrected');
});

it('has no printed text of a variant', () => {
  expect(missing({ method: 'warnock-full' })).toEqual(['depth:8', 'depth:16']);
  expect(missing({ method: 'warnock-full', edition: 'printed' })).toEqual(kernels);
  const asked = { ...usual, method: 'warnock-full', edition: 'printed', check: true } as const;
  expect(runnable({ ...asked, kernel: 'exact' })).toEqual({
    ...asked,
    edition: 'corrected',
    kernel: 'exact',
  });
  expect(runnable({ ...asked, kernel: 'depth:8' }).kernel).toBe('double');
});

it('falls back to double if the kernel does not run', () => {
  expect(runnable({ ...usual, kernel: 'filtered', edition: 'printed' }).kernel).toBe('double');
  expect(runnable({ ...usual, kernel: 'exact', edition: 'printed' }).kernel).toBe('exact');
});
