import { expect, it } from 'vitest';
import { middle, side } from './places.js';
import { SignMap } from './sign-map.js';

it('a map has its signs at the right places, and counts the wrong ones', () => {
  // A digit is 3 times (sign + 1) of the computed sign plus once of the exact one: positive instead of zero is 3 * 2 + 1.
  const digits = Array.from({ length: side * side }, () => '8');
  digits[middle * side + middle] = '7';
  digits[side + 2] = '0'; // the third place in the second row: negative twice
  digits[2] = '6'; // positive instead of negative
  const map = new SignMap(digits.join(''));
  expect(map.centre).toEqual({ computed: 1, exact: 0 });
  expect(map.at(2, 1)).toEqual({ computed: -1, exact: -1 });
  expect(map.at(2, 0)).toEqual({ computed: 1, exact: -1 });
  expect(map.at(0, 0)).toEqual({ computed: 1, exact: 1 });
  expect(map.wrong).toBe(2);
});
