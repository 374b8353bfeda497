import { describe, expect, it } from 'vitest';
import { parseAddress } from '../reader/address.js';
import { optionsOf, unpacked } from '../run/packed.js';
import { curveRunOf, runOf, surfaceSample } from '../testing/charts.js';
import { fileOfRun, linksOf } from './replay.js';

const page = new URL('file:///share/vidno/index.html');
const file = '{"format":"vidno-scene/1","name":"здесь & там"}';
const links = async (fields: Parameters<typeof runOf>[0], text = file) =>
  linksOf(runOf(fields), text, page, 'ru');

describe('a run on the chart', () => {
  it.each(['bits:8', 'grid:4', 'depth:12', 'float'])(
    'under %s is linked to its replay',
    async (kernel) => {
      const found = await links({ kernel });
      if (typeof found === 'string') throw new Error(found);
      const { hash, pathname } = new URL(found.replay);
      expect(pathname).toBe('/share/vidno/index.html');
      const { live, rival, setup } = parseAddress(hash);
      expect(await unpacked(live?.scene ?? '')).toBe(file);
      expect(optionsOf(live?.run ?? '')).toMatchObject({ method: 'zbuffer', kernel });
      expect([rival, setup.language]).toEqual([null, 'ru']);
      const beside = parseAddress(new URL(found.compare ?? '').hash);
      expect(beside).toMatchObject({ live, rival: 'zbuffer.corrected.exact.signs' });
    },
  );

  it('that is the exact one is not compared with another', async () => {
    expect(await links({ kernel: 'exact' })).toMatchObject({ compare: null });
    const printed = await links({ kernel: 'exact', edition: 'printed' });
    expect(printed).toHaveProperty('compare', expect.stringContaining('with='));
  });

  it('has no link if the page cannot make the run, or the scene is too large for an address', async () => {
    expect(await links({ method: 'warnock', window: 4, knob: 'window', value: 4 })).toBe('window');
    // Digits of squares are hard to compress: 100,000 of them take more than 12,000 bytes.
    const digits = Array.from({ length: 20000 }, (_, i) => (i * i * 7919) % 99991).join('');
    expect(await links({}, digits)).toBe('large');
  });
});

describe('a run of a surface', () => {
  const given = { format: 'vidno-surface/1', function: 'x * z', samples: 9, tolerance: 0.5 };

  it.each([
    [curveRunOf({}), given],
    [curveRunOf({ knob: 'samples', value: 5 }), { ...given, samples: 5, tolerance: undefined }],
    [curveRunOf({ knob: 'tolerance', value: 2 }), { ...given, samples: 2, tolerance: 2 }],
  ])('has the surface with the samples of the run (%#)', (run, file) => {
    expect(fileOfRun(given, run)).toBe(JSON.stringify(file));
  });

  it('is linked to its replay, alone and beside the exact run', async () => {
    const [surface] = surfaceSample.surfaces;
    const run = curveRunOf({ kernel: 'float', edition: 'printed', knob: 'samples', value: 3 });
    const text = fileOfRun(surface?.surface ?? {}, run);
    const found = await linksOf(run, text, page, 'en');
    if (typeof found === 'string') throw new Error(found);
    const { live, rival } = parseAddress(new URL(found.compare ?? '').hash);
    expect(await unpacked(live?.scene ?? '')).toBe(text);
    expect(JSON.parse(text)).toMatchObject({ samples: 3, window: { width: 33 } });
    expect(live?.run).toBe('floating-horizon.printed.float.signs');
    expect(rival).toBe('floating-horizon.corrected.exact.signs');
  });
});
