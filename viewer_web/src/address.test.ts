import { describe, expect, it } from 'vitest';
import { formatAddress, parseAddress } from './address.js';

describe('the address', () => {
  it('comes back as it was written', () => {
    const address = {
      language: 'ru',
      trace: '01-near & far.warnock',
      step: 17,
      pixel: [3, -4],
    } as const;
    expect(parseAddress(formatAddress(address))).toEqual(address);
  });

  it('forgets step and pixel where no lesson is open', () => {
    expect(formatAddress({ language: 'en', trace: null, step: 3, pixel: [1, 2] })).toBe('#lang=en');
  });

  it.each([
    '#step=-1',
    '#step=1e400',
    '#step=1.5',
    '#lang=xx',
    '#%%%',
    '',
    '#step=abc',
    '#pixel=1',
    '#pixel=1,2,3',
    '#pixel=1.5,2',
    '#pixel=1e3,2',
  ])('takes no nonsense: %s', (hash) => {
    expect(parseAddress(hash)).toEqual({ language: null, trace: null, step: 0, pixel: null });
  });
});
