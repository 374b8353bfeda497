import { describe, expect, it } from 'vitest';
import { between, following, inSteps, isWhole, moved, wholeOf, zoomed } from './range.js';

const length = 1000;

describe('a part of a run', () => {
  it('is between two steps, whichever is named first', () => {
    expect(between(300, 200, length)).toEqual({ from: 200, to: 300 });
    expect(between(-5, 2000, length)).toEqual(wholeOf(length));
  });

  it('has at least a few steps around the wanted ones, if the run has them', () => {
    expect(between(500, 502, length)).toEqual({ from: 497, to: 505 }); // 3 more on both sides
    expect(between(0, 1, length)).toEqual({ from: 0, to: 8 });
    expect(between(2, 2, 5)).toEqual(wholeOf(5));
  });

  it('becomes smaller around a step, which stays where it is', () => {
    // 250 is at a quarter of the run, and also of the 500 steps from 125 on.
    expect(zoomed(wholeOf(length), 2, 250, length)).toEqual({ from: 125, to: 625 });
    expect(zoomed({ from: 125, to: 625 }, 0.5, 250, length)).toEqual(wholeOf(length));
  });

  it('ends with the run', () => {
    // 900 is at 8/9 of the last 900 steps. 1,811 steps with 900 at the same place would extend to 2,020.
    expect(zoomed({ from: 100, to: 1000 }, 0.5, 900, length)).toEqual(wholeOf(length));
    expect(moved({ from: 850, to: 950 }, 200, length)).toEqual({ from: 900, to: 1000 });
    expect(moved({ from: 50, to: 150 }, -200, length)).toEqual({ from: 0, to: 100 });
    expect(isWhole(zoomed({ from: 900, to: 1000 }, 0.01, 950, length), length)).toBe(true);
  });

  it('grows again after the minimum, even in small increments', () => {
    let range = between(500, 500, length);
    for (let i = 0; i < 20; i++) range = zoomed(range, 0.98, 500, length);
    expect(inSteps(range).to - inSteps(range).from).toBe(12); // 8 / 0.98^20 = 11.98
  });
});

describe('a part of a run that follows a step', () => {
  const range = { from: 200, to: 300 };

  it('stays while it contains the step', () => {
    expect(following(range, 200, length)).toBe(range);
    expect(following(range, 300, length)).toBe(range);
  });

  it('keeps a tenth of itself behind the step, in both directions', () => {
    expect(following(range, 301, length)).toEqual({ from: 291, to: 391 });
    expect(following(range, 199, length)).toEqual({ from: 109, to: 209 });
  });

  it('stays within the run', () => {
    expect(following(range, length, length)).toEqual({ from: 900, to: 1000 });
    expect(following(range, 0, length)).toEqual({ from: 0, to: 100 });
  });
});
