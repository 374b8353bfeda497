import { describe, expect, it } from 'vitest';
import { parseAddress } from '../address.js';
import { optionsOf, unpacked } from '../live/packed.js';
import { runOf } from '../testing/charts.js';
import { linksOf } from './replay.js';

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

  it('that is the exact one is held against no other', async () => {
    expect(await links({ kernel: 'exact' })).toMatchObject({ compare: null });
    const printed = await links({ kernel: 'exact', edition: 'printed' });
    expect(printed).toHaveProperty('compare', expect.stringContaining('with='));
  });

  it('has no link where the page has no such run, or the scene is too large for an address', async () => {
    expect(await links({ method: 'warnock', window: 4, knob: 'window', value: 4 })).toBe('window');
    // Digits of squares do not pack well: 100,000 of them are more than 12,000 bytes.
    const digits = Array.from({ length: 20000 }, (_, i) => (i * i * 7919) % 99991).join('');
    expect(await links({}, digits)).toBe('large');
  });
});
