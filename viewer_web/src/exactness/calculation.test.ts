import { expect, it } from 'vitest';
import { calculation, hasDrifted, inNotation, withoutOne } from './calculation.js';
import { Fraction } from './fraction.js';

it('adds, multiplies and writes fractions in lowest terms', () => {
  const third = Fraction.of(1, 3);
  const sixth = Fraction.of(-2, -12);
  expect(third.plus(sixth).text).toBe('1/2');
  expect(third.minus(sixth.times(Fraction.of(4))).text).toBe('−1/3');
  expect(third.over(sixth).text).toBe('2');
  expect(Fraction.of(-7, 2).floor).toBe(-4n);
  expect(Fraction.parse('nan')).toBe(null);
});

it('calculates a cross product line by line', () => {
  // (4 − 0)(2 − 0) − (0 − 0)(1 − 0) = 8.
  const operands = [
    ['pivot.x', '0/1', '0/1'],
    ['pivot.y', '0/1', '0/1'],
    ['a.x', '4/1', '4/1'],
    ['a.y', '0/1', '0/1'],
    ['b.x', '1/1', '1/1'],
    ['b.y', '2/1', '2/1'],
  ] as const;
  expect(calculation('orientation', operands, 'exact')).toEqual([
    'f = (aₓ − oₓ) (bᵧ − oᵧ) − (aᵧ − oᵧ) (bₓ − oₓ)',
    '= 4 · 2 − 0 · 1',
    '= 8 − 0',
    '= 8 > 0',
  ]);
});

it('calculates with the numbers of the run, too, if they have drifted', () => {
  const operands = [
    ['z', '1/2', '1/3'],
    ['against', '2/5', '2/5'],
  ] as const;
  expect(hasDrifted(operands)).toBe(true);
  expect(calculation('nearer', operands, 'used')?.at(-1)).toBe('z > against');
  expect(calculation('nearer', operands, 'exact')?.slice(2)).toEqual([
    'z − against = −1/15 < 0',
    'z < against',
  ]);
});

it('finds the first and the last pixel centre', () => {
  // The centres are 2.5, 3.5, and so on. The first one at or after 5/2 is that of column 2; the last one up to 7/3 is that
  // of column 1.
  const at = (x: string) =>
    [
      ['x', x, x],
      ['low', '0/1', '0/1'],
      ['end', '4/1', '4/1'],
    ] as const;
  expect(calculation('first_centre', at('5/2'), 'exact')?.at(-1)).toBe(
    'i + 1/2 ≥ 5/2 ⇒ i = ⌈2⌉ = 2',
  );
  expect(calculation('last_centre', at('7/3'), 'exact')?.at(-1)).toBe(
    'i + 1/2 ≤ 7/3 ⇒ i = ⌊11/6⌋ = 1',
  );
  // Outside the range, 9 is limited to its end, and −3 to one before its beginning.
  expect(calculation('first_centre', at('19/2'), 'exact')?.at(-1)).toContain('9 → 4');
  expect(calculation('last_centre', at('-5/2'), 'exact')?.at(-1)).toContain('−3 → −1');
});

it('gives nothing if an operand is not a number', () => {
  expect(
    calculation(
      'nearer',
      [
        ['z', 'nan', '1/2'],
        ['against', '0/1', null],
      ],
      'used',
    ),
  ).toBe(null);
  expect(
    calculation(
      'nearer',
      [
        ['z', '1/2', '1/2'],
        ['against', '-inf', '-inf'],
      ],
      'exact',
    ),
  ).toBe(null);
});

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
