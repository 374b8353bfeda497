import { describe, expect, it } from 'vitest';
import { FormulaRefused, heightFunction } from './height-function.js';

const at = (text: string, x = 2, z = 3): number => heightFunction(text, Math)(x, z);

describe('a formula', () => {
  it.each([
    ['x - z * 2', -4],
    ['-x^2', -4],
    ['2^x^z', 256],
    ['2^-1', 0.5],
    ['(x + z) / 2', 2.5],
    ['x < z ? 10 : 20', 10],
    ['x == 2 ? 1 : 0', 1],
    ['x >= z', 0],
    ['(x < z) * 5', 5],
    ['1e3 + .5', 1000.5],
    ['max(x, z, 7) + min(x, z) + sum(1, 2) + avg(2, 4)', 15],
    ['abs(-x) + sqrt(16) + atan2(0, 1) + sign(z)', 7],
    ['ln(exp(1)) + log(_e) + log10(100) + log2(8)', 7],
    ['cos(pi) + cos(_pi)', -2],
  ])('%s has the same value as in muParser', (text, value) => {
    expect(at(text)).toBeCloseTo(value, 14);
  });

  it('distinguishes numbers by their last bit, as the program does', () => {
    expect(at('x == 1 ? 1 : 0', 1 + Number.EPSILON)).toBe(0);
  });

  it.each([
    '',
    'x +',
    '2x',
    'y',
    'e',
    'sin x',
    'sin()',
    'sin(x, z)',
    'min()',
    'rint(x)',
    'x = 3',
    'x; z',
    'x && z',
    'x and z',
    'x!',
    'x % 2',
    '+x',
    '[x]',
    '"x"',
    'x # more',
    'x < z < 4',
    'f(x) = x',
    'x.constructor',
    'constructor(x)',
    'import(x)',
    'toString',
  ])('%s is refused', (text) => {
    expect(() => heightFunction(text, Math)).toThrow(FormulaRefused);
  });

  it.each([
    ['rint(x)', 'rint: no such function'],
    ['sin(x, z)', 'sin: takes another number of arguments'],
    ['x + y', 'y: not known; there are x, z and pi'],
    ['2 x', 'a product is written with *'],
    ['x % 2', 'empty, or with signs that no formula has'],
    ['x !', '!: not taken here'],
    ['x = 3', 'this is more than a formula'],
    ['x +', 'it ends too early'],
    ['(x', 'it ends too early'],
    ['x + ) + z', ') + z: not understood'],
  ])('%s is refused with a reason', (text, reason) => {
    expect(() => heightFunction(text, Math)).toThrow(reason);
  });
});
