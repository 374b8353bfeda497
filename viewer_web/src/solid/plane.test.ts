import { describe, expect, it } from 'vitest';
import type { Polygon } from '../trace/header.js';
import { planeOf } from '../trace/polygon.js';
import { holds, patchOf } from './plane.js';

const polygon = (...vertices: Polygon['vertices']): Polygon => ({
  id: 'T',
  color: '#cc79a7',
  vertices,
});

// z rises by 1/16 for each unit of x and of y: 4 p + q/2 = 9/32 = p/2 + 4 q.
const triangle = polygon([2, 2, -0.375], [6, 2.5, -0.09375], [2.5, 6, -0.09375]);

describe('the plane of a polygon', () => {
  it('has a depth at each corner of the window, even outside the polygon', () => {
    const plane = planeOf(triangle);
    expect([plane(0, 0), plane(0, 16), plane(16, 0), plane(16, 16)]).toEqual([
      -0.625, // -3/8 - 4/16
      0.375, // a whole 16/16 more
      0.375,
      1.375,
    ]);
  });

  it('is the same for both directions of the polygon', () => {
    const [a, b, c] = triangle.vertices;
    if (!a || !b || !c) throw new Error('no triangle');
    expect(planeOf(polygon(c, b, a))(16, 16)).toBe(1.375);
  });

  it('has no depth where it is seen edge-on', () => {
    expect(planeOf(polygon([0, 0, 0], [4, 4, 0], [4, 4, 1], [0, 0, 1]))(1, 1)).toBe(NaN);
  });
});

describe('the part of a plane over a window', () => {
  const slope = (x: number): number => x / 2;

  it('is the whole if its depths are in the box', () => {
    expect(patchOf(slope, [0, 0, 4, 2], [0, 2])).toEqual([
      [0, 0, 0],
      [4, 0, 2],
      [4, 2, 2],
      [0, 2, 0],
    ]);
  });

  it('ends where the box does', () => {
    // z = x / 2 is 0.5 at x = 1, and 1.5 at x = 3.
    const patch = patchOf(slope, [0, 0, 4, 2], [0.5, 1.5]);
    expect(new Set(patch.map(String))).toEqual(
      new Set(['1,0,0.5', '3,0,1.5', '3,2,1.5', '1,2,0.5']),
    );
    expect(patch).toHaveLength(4);
  });

  it('is empty if the plane is before or behind the box', () => {
    expect(patchOf(slope, [0, 0, 4, 2], [3, 4])).toEqual([]);
  });
});

describe('an outline', () => {
  it.each([
    [3, 3, true],
    [4, 2.25, true], // the middle of the upper edge
    [2, 2, true],
    [5, 5, false],
  ])('contains (%s, %s): %s', (x, y, inside) => {
    expect(holds(triangle, x, y)).toBe(inside);
  });
});
