import { expect, it } from 'vitest';
import type { Finding } from '../exactness/finding.js';
import { numberOf } from '../trace/events.js';
import { leveled, placedIn } from './leveled.js';

/** A window that is examined: the levels from which its events appear are in brackets. */
const signs = new TextEncoder().encode(
  [
    '{"format":"vidno-trace/1"}',
    '{"e":"pop","at":"W5","window":[0,0,1,1]}', // 1 (windows)
    '{"e":"call","at":"W6","of":"ProcessWindow"}', // 2 (polygons)
    '{"e":"call","at":"PW8","of":"SurroundTest"}', // 3 (signs)
    '{"e":"orient","at":"S2","polygon":"A"}', // 4 (signs)
    '{"e":"summary","at":"W6","count":1}', // 5 (polygons)
    '{"e":"decide","at":"W8","case":"surrounded"}', // 6 (windows)
    '{"end":"complete"}',
    '',
  ].join('\n'),
);

it('finds the step of a coarser level that contains a step', () => {
  // The events of level polygons are 1, 2, 5 and 6; what happens at 4 leads to the third of them.
  expect(leveled(signs, 'polygons', [2, 4, 4, 5])).toEqual([
    { step: 2, isShown: true },
    { step: 3, isShown: false },
    { step: 3, isShown: false },
    { step: 3, isShown: true },
  ]);
  // Those of level windows are 1 and 6.
  expect(leveled(signs, 'windows', [1, 4, 6])).toEqual([
    { step: 1, isShown: true },
    { step: 2, isShown: false },
    { step: 2, isShown: true },
  ]);
});

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
