import { describe, expect, it } from 'vitest';
import { between, following, inSteps, isWhole, moved, wholeOf, zoomed } from './range.js';

const length = 1000;

describe('a part of a run', () => {
  it('is between two steps, whichever is named first', () => {
    expect(between(300, 200, length)).toEqual({ from: 200, to: 300 });
    expect(between(-5, 2000, length)).toEqual(wholeOf(length));
  });

  it('has a few steps at least, around those that are meant, if the run has them', () => {
    expect(between(500, 502, length)).toEqual({ from: 497, to: 505 }); // 3 more on both sides
    expect(between(0, 1, length)).toEqual({ from: 0, to: 8 });
    expect(between(2, 2, 5)).toEqual(wholeOf(5));
  });

  it('becomes smaller around a step, which stays where it is', () => {
    // 250 stands at a quarter of the run; so it does of the 500 steps from 125 on.
    expect(zoomed(wholeOf(length), 2, 250, length)).toEqual({ from: 125, to: 625 });
    expect(zoomed({ from: 125, to: 625 }, 0.5, 250, length)).toEqual(wholeOf(length));
  });

  it('ends with the run', () => {
    // 900 stands at 8/9 of the last 900 steps; 100 of them around it would go on to 911 and 1,811 of them to 2,020.
    expect(zoomed({ from: 100, to: 1000 }, 0.5, 900, length)).toEqual(wholeOf(length));
    expect(moved({ from: 850, to: 950 }, 200, length)).toEqual({ from: 900, to: 1000 });
    expect(moved({ from: 50, to: 150 }, -200, length)).toEqual({ from: 0, to: 100 });
    expect(isWhole(zoomed({ from: 900, to: 1000 }, 0.01, 950, length), length)).toBe(true);
  });

  it('gets larger again after it was as small as can be, however little at a time', () => {
    let range = between(500, 500, length);
    for (let i = 0; i < 20; i++) range = zoomed(range, 0.98, 500, length);
    expect(inSteps(range).to - inSteps(range).from).toBe(12); // 8 / 0.98^20 = 11.98
  });
});

describe('a part of a run that follows a step', () => {
  const range = { from: 200, to: 300 };

  it('stays while the step is in it', () => {
    expect(following(range, 200, length)).toBe(range);
    expect(following(range, 300, length)).toBe(range);
  });

  it('keeps a tenth of itself behind the step, on the way forward and on the way back', () => {
    expect(following(range, 301, length)).toEqual({ from: 291, to: 391 });
    expect(following(range, 199, length)).toEqual({ from: 109, to: 209 });
  });

  it('stays within the run', () => {
    expect(following(range, length, length)).toEqual({ from: 900, to: 1000 });
    expect(following(range, 0, length)).toEqual({ from: 0, to: 100 });
  });
});
