import { describe, expect, it } from 'vitest';
import { formatAddress, parseAddress } from './address.js';

describe('the address', () => {
  it('comes back as it was written', () => {
    const address = { language: 'ru', trace: '01-near & far.warnock', step: 17 } as const;
    expect(parseAddress(formatAddress(address))).toEqual(address);
  });

  it('forgets the step where no lesson is open', () => {
    expect(formatAddress({ language: 'en', trace: null, step: 3 })).toBe('#lang=en');
  });

  it.each(['#step=-1', '#step=1e400', '#step=1.5', '#lang=xx', '#%%%', '', '#step=abc'])(
    'takes no nonsense: %s',
    (hash) => {
      expect(parseAddress(hash)).toEqual({ language: null, trace: null, step: 0 });
    },
  );
});
