import { expect, it } from 'vitest';
import { allSeries, lookOf } from '../series.js';
import { colors } from './colors.style.js';

it('each method, variant and kernel has a colour', () => {
  const withoutKnob = allSeries.filter(({ knob }) => knob === null);
  const missing = withoutKnob.filter((series) => {
    const [, name = ''] = /^var\((.*)\)$/u.exec(lookOf(series).color) ?? [];
    return !colors.cssText.includes(`${name}:`);
  });
  expect(missing.map(({ id }) => id)).toEqual([]);
});
