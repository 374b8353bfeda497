import { expect, it } from 'vitest';
import { inNotation, withoutOne } from './notation.js';

it('writes operands with the symbols of the listings, and horizons in the language', () => {
  expect(inNotation('z − against = −1/15 < 0', 'en', 'Z')).toBe('z − Z = −1/15 < 0');
  expect(inNotation('against = 2/5', 'ru')).toBe('z₀ = 2/5');
  expect(inNotation('left = 1', 'en')).toBe('x₁ = 1');
  expect(inNotation('y < upper', 'en')).toBe('y < upper');
  expect(inNotation('y < upper', 'ru')).toBe('y < верхний');
});

it('writes whole numbers without a denominator', () => {
  expect(['4/1', '1/11', '0.5', '−3/1'].map(withoutOne)).toEqual(['4', '1/11', '0.5', '−3']);
});
