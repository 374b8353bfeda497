import { expect, it } from 'vitest';
import { middle, side } from './places.js';
import { SignMap } from './sign-map.js';

it('a map has its signs where they belong, and counts those that are wrong', () => {
  // 3 times (sign + 1) of the computed one and once of the exact one: positive for zero is 3 * 2 + 1.
  const digits = Array.from({ length: side * side }, () => '8');
  digits[middle * side + middle] = '7';
  digits[side + 2] = '0'; // in the second row, the third: negative twice
  digits[2] = '6'; // positive for negative
  const map = new SignMap(digits.join(''));
  expect(map.centre).toEqual({ computed: 1, exact: 0 });
  expect(map.at(2, 1)).toEqual({ computed: -1, exact: -1 });
  expect(map.at(2, 0)).toEqual({ computed: 1, exact: -1 });
  expect(map.at(0, 0)).toEqual({ computed: 1, exact: 1 });
  expect(map.wrong).toBe(2);
});
