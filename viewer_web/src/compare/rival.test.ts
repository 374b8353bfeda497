import { describe, expect, it } from 'vitest';
import { usual } from '../run/options.js';
import { wordOf } from '../run/packed.js';
import { quickRuns } from './rival.js';

describe('quick comparisons are offered for a run with', () => {
  it('the other method, the other edition, exact numbers and float', () => {
    const words = quickRuns(usual).map(([name, options]) => [name, wordOf(options)]);
    expect(words).toEqual([
      ['method', 'zbuffer.corrected.double.signs'],
      ['variant', 'warnock-full.corrected.double.signs'],
      ['printed', 'warnock.printed.double.signs'],
      ['exact', 'warnock.corrected.exact.signs'],
      ['float', 'warnock.corrected.float.signs'],
    ]);
  });

  it('the method that it is a variant of, and no printed text', () => {
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

  it('the corrected text, for a usual mistake, and only kernels that run it', () => {
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

  it('options that can be run, with another kernel if necessary', () => {
    const depth = quickRuns({ ...usual, method: 'zbuffer', kernel: 'depth:8' });
    expect(depth[0]?.[1].kernel).toBe('double');
    const filtered = quickRuns({ ...usual, kernel: 'filtered' });
    expect(filtered[2]).toMatchObject(['printed', { edition: 'printed', kernel: 'double' }]);
  });
});
