import { describe, expect, it } from 'vitest';
import { wordOf } from '../run/packed.js';
import { usual } from '../run/options.js';
import { quickRuns } from './quick.js';

describe('a run is quickly held against', () => {
  it('the other method, the other text, exact numbers and float', () => {
    const words = quickRuns(usual).map(([name, options]) => [name, wordOf(options)]);
    expect(words).toEqual([
      ['method', 'zbuffer.corrected.double.signs'],
      ['variant', 'warnock-full.corrected.double.signs'],
      ['printed', 'warnock.printed.double.signs'],
      ['exact', 'warnock.corrected.exact.signs'],
      ['float', 'warnock.corrected.float.signs'],
    ]);
  });

  it('of a variant without a printed text, by the method it is one of', () => {
    const words = quickRuns({ ...usual, method: 'warnock-full' }).map(([name, options]) => [
      name,
      wordOf(options),
    ]);
    expect(words).toEqual([
      ['method', 'warnock.corrected.double.signs'],
      ['exact', 'warnock-full.corrected.exact.signs'],
      ['float', 'warnock-full.corrected.float.signs'],
    ]);
  });

  it('of a usual mistake, the corrected text, and no numbers that do not run it', () => {
    const words = quickRuns({ ...usual, edition: 'surround-kept' }).map(([name, options]) => [
      name,
      wordOf(options),
    ]);
    expect(words).toEqual([
      ['method', 'zbuffer.corrected.double.signs'],
      ['variant', 'warnock-full.corrected.double.signs'],
      ['corrected', 'warnock.corrected.double.signs'],
      ['exact', 'warnock.surround-kept.exact.signs'],
    ]);
  });

  it('what can be run: the kernel gives way', () => {
    const depth = quickRuns({ ...usual, method: 'zbuffer', kernel: 'depth:8' });
    expect(depth[0]?.[1].kernel).toBe('double');
    const filtered = quickRuns({ ...usual, kernel: 'filtered' });
    expect(filtered[2]).toMatchObject(['printed', { edition: 'printed', kernel: 'double' }]);
  });
});
