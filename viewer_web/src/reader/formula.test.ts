import { expect, it } from 'vitest';
import { withNumbersIn } from './formula.js';

it.each([
  ['z = -0.25', 'z = -0{,}25'],
  ['2^{19} = 524{,}288', '2^{19} = 524\\,288'],
  ['(8.5, 1)', '(8{,}5; 1)'],
  ['k = 0, 1, 2', 'k = 0, 1, 2'],
  ['x = 1.5,\\, y', 'x = 1{,}5;\\, y'],
])('a Russian formula has a decimal comma: %s', (tex, russian) => {
  expect(withNumbersIn('ru', tex)).toBe(russian);
  expect(withNumbersIn('en', tex)).toBe(tex);
});
