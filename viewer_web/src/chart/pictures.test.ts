import { describe, expect, it } from 'vitest';
import { curveRunOf, runOf, sceneOf, surfaceOf } from '../testing/charts.js';
import { pairOf } from './pictures.js';

// Two rows of three pixels. The right picture is white but for the last pixel of the first row and the first of the
// second; in the other one, the second pixel of the first row is blue, too.
const pictures = {
  width: 3,
  colors: ['#ffffff', '#0000ff'],
  shown: [
    [2, 0, 2, 1, 2, 0],
    [1, 0, 3, 1, 2, 0],
  ],
};

describe('the picture of a run', () => {
  it('is drawn beside the right picture, and pixels that differ are outlined', () => {
    const pair = pairOf(sceneOf([], { pixels: 6, pictures }), runOf({ picture: 1 }));
    expect(pair?.own.strips).toEqual([
      { x: 0, y: 0, width: 1, color: '#ffffff' },
      { x: 1, y: 0, width: 2, color: '#0000ff' },
      { x: 0, y: 1, width: 1, color: '#0000ff' },
      { x: 1, y: 1, width: 2, color: '#ffffff' },
    ]);
    expect(pair?.right).toMatchObject({ width: 3, height: 2 });
    expect(pair?.wrong).toMatchObject([{ x: 1, y: 0, width: 1 }]);
  });

  it('has no wrong pixel if it is the right one', () => {
    const pair = pairOf(sceneOf([], { pixels: 6, pictures }), runOf({ picture: 0 }));
    expect(pair?.wrong).toEqual([]);
  });

  it('of a surface has lines', () => {
    const drawn = {
      width: 9,
      height: 5,
      shown: [
        [[0, 1, 8, 1]],
        [
          [0, 1, 4, 2, 8, 1],
          [0, 4, 8, 4],
        ],
      ],
    };
    const pair = pairOf(surfaceOf([], { pictures: drawn }), curveRunOf({ picture: 1 }));
    expect(pair?.own.lines).toEqual([
      [
        [0, 1],
        [4, 2],
        [8, 1],
      ],
      [
        [0, 4],
        [8, 4],
      ],
    ]);
    expect(pair?.right.lines).toEqual([
      [
        [0, 1],
        [8, 1],
      ],
    ]);
  });

  it.each([
    ['is not in the chart', 6, runOf({})],
    ['has no such place', 6, runOf({ picture: 2 })],
    ['has another size', 7, runOf({ picture: 1 })],
  ])('is left out if it %s', (_why, pixels, run) => {
    expect(pairOf(sceneOf([], { pixels, pictures }), run)).toBeNull();
  });
});
