import { describe, expect, it } from 'vitest';
import { placeOf, stepOf, ticksIn } from './axes.js';

describe('the numbers of an axis', () => {
  it('stand at the centres of pixels, or where the samples of curves are', () => {
    // Pixel 8 reaches from 8 to 9, but the sample of column 8 has x = 8.
    expect(placeOf(8, 'pixels')).toBe(8.5);
    expect(placeOf(8, 'lines')).toBe(8);
  });

  it.each([
    [0.1, 1],
    [1, 1],
    [1.1, 2],
    [3, 5],
    [6, 10],
    [51, 100],
  ])('at least %d apart are %d apart', (least, step) => {
    expect(stepOf(least)).toBe(step);
  });

  it('are multiples of their distance, wherever the axis begins', () => {
    expect(ticksIn(0, 15, 2)).toEqual([0, 2, 4, 6, 8, 10, 12, 14]);
    expect(ticksIn(-7, 8, 4)).toEqual([-5, 0, 5]);
    expect(ticksIn(3, 4, 5)).toEqual([]);
  });
});
