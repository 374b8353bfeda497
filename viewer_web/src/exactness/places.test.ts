import { describe, expect, it } from 'vitest';
import { middle, placesAround, ulp } from './places.js';

describe('an ulp', () => {
  it.each([
    [0.5, 'double', 2 ** -53], // 0.5 = 2^-1, 52 bits after the first
    [1, 'double', 2 ** -52],
    [-4.5, 'float', 2 ** -21], // 4 = 2^2, 23 bits after the first
    [6.5, 'bits:8', 2 ** -5], // 2^2, 7 bits
    [2 ** 29, 'double', 2 ** -23], // where the rounded logarithm must not matter
    [7.999999999999999, 'exact', 2 ** -50],
  ])('of %d under %s', (value, kernel, expected) => {
    expect(ulp(value, kernel)).toBe(expected);
  });
});

describe('the places around a point', () => {
  it('have it in their middle, by the ulp of its greater coordinate', () => {
    const places = placesAround([0.1, 4.5], 'double');
    expect(places?.step).toBe(2 ** -50);
    expect(places?.p[0]).toBe(0.1 - middle * 2 ** -50);
    expect(places?.p[1]).toBe(4.5 - middle * 2 ** -50);
  });

  it('do not exist where they are not doubles', () => {
    // y is the double before 1. A step of 2^-52 further, 1 + 2^-53, lies halfway between two doubles.
    expect(placesAround([1, 1 - 2 ** -53], 'double')).toBeNull();
    expect(placesAround([1, 1 - 2 ** -53], 'float')).toBeNull();
  });

  it('do not exist for NaN', () => {
    expect(placesAround([NaN, 0], 'double')).toBeNull();
  });
});
