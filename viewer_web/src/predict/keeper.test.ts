import { describe, expect, it } from 'vitest';
import { joined, percentOf, readScore, shortScore } from './keeper.js';
import type { Count, Score } from './score.js';

const counted = (asked: number, right: number, points: number, parts: number): Count => ({
  asked,
  right,
  given_up: 0,
  points,
  parts,
});

const run = {
  scene: 'A square',
  method: 'warnock',
  edition: 'corrected',
  kernel: 'double',
  detail: 'signs',
  events: 9,
  answers: [],
} as const;

const earlier: Score = {
  format: 'vidno-score/1',
  total: counted(3, 1, 4, 7),
  kinds: { window: counted(2, 1, 4, 5), inside: counted(1, 0, 0, 2) },
  runs: [run],
};

const later: Score = {
  format: 'vidno-score/1',
  name: 'Ada',
  total: counted(2, 2, 4.67, 5),
  kinds: { inside: counted(1, 1, 1.67, 2), window: counted(1, 1, 3, 3) },
  runs: [{ ...run, scene: 'A slope' }],
};

describe('the score of several visits', () => {
  it('has the sums of their counts, and all their answers', () => {
    expect(joined(earlier, later)).toEqual({
      format: 'vidno-score/1',
      name: 'Ada',
      total: counted(5, 3, 8.67, 12),
      kinds: { window: counted(3, 2, 7, 8), inside: counted(2, 1, 1.67, 4) },
      runs: [run, { ...run, scene: 'A slope' }],
    });
  });

  it('is that of this visit if it is the first', () => {
    expect(joined(null, later)).toBe(later);
  });
});

describe('the percentage', () => {
  it('is that of the points', () => {
    expect(percentOf(counted(5, 3, 8.67, 12), 5)).toBe(72.25);
    expect(percentOf(counted(9, 3, 1, 3), 5)).toBe(33.33);
  });

  it('counts the questions that are still wanted as wrong', () => {
    // 3 of 4 points, in 2 of 5 questions.
    expect(percentOf(counted(2, 1, 3, 4), 5)).toBe(30);
    expect(percentOf(counted(0, 0, 0, 0), 5)).toBe(0);
  });
});

describe('the score as a short text', () => {
  it('is read again', () => {
    expect(readScore(shortScore(earlier, 4096))).toEqual(earlier);
  });

  it('has no answers if it would be too long with them', () => {
    const whole = JSON.stringify(earlier).length;
    expect(readScore(shortScore(earlier, whole))).toEqual(earlier);
    expect(readScore(shortScore(earlier, whole - 1))).toEqual({ ...earlier, runs: [] });
  });

  it.each([
    '',
    'null',
    '[1]',
    '{"format":"vidno-score/2"}',
    JSON.stringify({ ...earlier, total: { asked: 3 } }),
    JSON.stringify({ ...earlier, kinds: undefined }),
    JSON.stringify({ ...earlier, kinds: { window: 3 } }),
    JSON.stringify({ ...earlier, runs: undefined }),
  ])('is none if it is %j', (text) => {
    expect(readScore(text)).toBeNull();
  });
});
