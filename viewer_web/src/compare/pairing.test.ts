import { describe, expect, it } from 'vitest';
import { Pairing, common, rising } from './pairing.js';

describe('common landmarks', () => {
  it('are those of both runs', () => {
    const one = new Map([
      ['a', 1],
      ['b', 3],
      ['c', 7],
    ]);
    const other = new Map([
      ['a', 2],
      ['x', 4],
      ['c', 5],
    ]);
    expect(common(one, other)).toEqual([
      [1, 2],
      [7, 5],
    ]);
  });

  it('are a longest sequence with the same order in both', () => {
    // Here the polygons are drawn in the order A B C D, there as D A C B. A C is a longest common subsequence, and so is A
    // B.
    expect(
      rising([
        [1, 20],
        [2, 40],
        [3, 30],
        [4, 10],
      ]),
    ).toEqual([
      [1, 20],
      [3, 30],
    ]);
    expect(rising([])).toEqual([]);
  });
});

describe('a pairing', () => {
  it('goes step by step from one landmark to the next, and waits before it', () => {
    // Between the landmarks there are 3 steps here and 1 there, then 1 here and 4 there.
    const pairing = new Pairing(
      [
        [2, 2],
        [6, 4],
      ],
      [8, 9],
    );
    const steps = Array.from({ length: 9 }, (_, step) => pairing.other(step));
    expect(steps).toEqual([0, 1, 2, 3, 3, 3, 4, 5, 9]);
  });

  it('is proportional where the runs have no common landmark', () => {
    const pairing = new Pairing([], [4, 10]);
    expect(pairing.byShare).toBe(true);
    expect([0, 1, 2, 3, 4].map((step) => pairing.other(step))).toEqual([0, 3, 5, 8, 10]);
  });
});
