import { expect, it } from 'vitest';
import type { Finding } from '../exactness/finding.js';
import { numberOf } from '../trace/events.js';
import { placedIn } from './finder.js';

it('does not count the steps that report wrong decisions', () => {
  const [pixel = NaN, disagree = NaN] = ['pixel', 'disagree'].map((name) =>
    numberOf.get(name as 'pixel'),
  );
  const finding = (step: number): Finding => ({
    ...{ kind: 'wrong', step, at: 'L6', procedure: 'ShowLine' },
    ...{ polygons: [], pixels: [0, 0, 1, 1], operands: [] },
  });
  // The run has the pixels 1, 2 and 3; the trace reports after the first that it is wrong.
  const placed = placedIn([pixel, disagree, pixel, pixel], [finding(1), finding(2), finding(3)]);
  expect(placed.map(({ step }) => step)).toEqual([1, 3, 4]);
});
