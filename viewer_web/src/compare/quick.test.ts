import { describe, expect, it } from 'vitest';
import { wordOf } from '../live/packed.js';
import { usual } from '../live/options.js';
import { quickRuns } from './quick.js';

describe('a run is quickly held against', () => {
  it('the other method, the other text, exact numbers and float', () => {
    const words = quickRuns(usual).map(([name, options]) => [name, wordOf(options)]);
    expect(words).toEqual([
      ['method', 'zbuffer.corrected.double.signs'],
      ['printed', 'warnock.printed.double.signs'],
      ['exact', 'warnock.corrected.exact.signs'],
      ['float', 'warnock.corrected.float.signs'],
    ]);
  });

  it('what can be run: the kernel gives way', () => {
    const depth = quickRuns({ ...usual, method: 'zbuffer', kernel: 'depth:8' });
    expect(depth[0]?.[1].kernel).toBe('double');
    const filtered = quickRuns({ ...usual, kernel: 'filtered' });
    expect(filtered[1]).toMatchObject(['printed', { edition: 'printed', kernel: 'double' }]);
  });
});
