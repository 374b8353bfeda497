import { describe, expect, it } from 'vitest';
import type { Region } from '../trace/values.js';
import { areaOf, boundsOf, hatchData, holds, loopsOf, regionData } from './geometry.js';

const outline = [
  [0, 0],
  ['8/1', 0],
  [8, 8],
  [0, 8],
] as const;
/** In the opposite direction. */
const hole = [
  [2, 2],
  [2, 6],
  [6, 6],
  [6, 2],
] as const;
const ring: Region = [outline, hole];

describe('a region with a hole', () => {
  it('has the area of its outline without that of the hole', () => {
    expect(areaOf(ring)).toBe(64 - 16);
  });

  it('does not contain points in the hole', () => {
    expect(holds(ring, [1, 4])).toBe(true);
    expect(holds(ring, [4, 4])).toBe(false);
    expect(holds(ring, [9, 4])).toBe(false);
  });

  it('has the bounding box of its outline', () => {
    expect(boundsOf(ring)).toEqual({ from: [0, 0], to: [8, 8] });
  });

  it('is hatched only outside the hole', () => {
    // x + y = 4 meets the outline at (0, 4) and (4, 0), and the hole at its corner (2, 2).
    const lines = hatchData(ring, 1, 4, [0, 0, 8, 8]);
    expect(lines.startsWith('M0 4L')).toBe(true);
    // x + y = 8 is the diagonal: from (0, 8) to (2, 6), and from (6, 2) to (8, 0).
    expect(lines).toContain('M0 8L2 6M6 2L8 0');
  });

  it('is hatched only where it is in sight', () => {
    expect(hatchData(ring, 1, 1, [0, 0, 1, 1]).match(/M/g)).toHaveLength(1);
  });
});

describe('a loop with a point that is not a number', () => {
  it('is not drawn', () => {
    const broken: Region = [
      [
        [0, 0],
        ['inf', 0],
        [0, 'nan'],
      ],
      outline,
    ];
    expect(loopsOf(broken)).toHaveLength(1);
    expect(regionData(broken)).toBe('M0 0L8 0L8 8L0 8Z');
  });
});
