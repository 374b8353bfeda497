import { expect, it } from 'vitest';
import type { Box } from '../trace/values.js';
import { sidesData } from './shapes.js';

it.each<[string, readonly Box[], string]>([
  ['of one box', [[1, 2, 3, 4]], 'M1 2H4M1 6H4M1 2V6M4 2V6'],
  [
    'of neighbours share the line between them',
    [
      [0, 0, 2, 2],
      [2, 0, 2, 2],
    ],
    'M0 0H4M0 2H4M0 0V2M2 0V2M4 0V2',
  ],
  [
    'of a box and its quarter',
    [
      [0, 0, 4, 4],
      [2, 2, 2, 2],
    ],
    'M0 0H4M0 4H4M2 2H4M0 0V4M4 0V4M2 2V4',
  ],
  [
    'that do not touch stay apart',
    [
      [3, 0, 1, 1],
      [0, 0, 1, 1],
    ],
    'M0 0H1M3 0H4M0 1H1M3 1H4M3 0V1M4 0V1M0 0V1M1 0V1',
  ],
])('the sides %s', (_, boxes, expected) => {
  expect(sidesData(boxes)).toBe(expected);
});
