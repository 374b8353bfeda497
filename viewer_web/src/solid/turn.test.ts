import { describe, expect, it } from 'vitest';
import { extent, seen, toViewer, turned, upward, views } from './turn.js';
import type { Turn } from './turn.js';

const near = (found: readonly number[], expected: readonly number[]): void => {
  found.forEach((each, i) => expect(each).toBeCloseTo(expected[i] ?? NaN));
};

describe('a place in the box', () => {
  it('is seen from the front as in the picture', () => {
    near(seen(views.front, [3, 2, 1]), [3, 2]);
  });

  it('appears from the side farther to the right, the nearer it is', () => {
    near(seen(views.side, [3, 2, 1]), [1, 2]);
  });

  it('appears from above lower, the nearer it is', () => {
    near(seen({ right: 0, above: 90 }, [3, 2, 1]), [3, 1]);
  });

  it('appears to the camera at the place of its label', () => {
    const turn: Turn = { right: -35, above: 25 };
    const [up, out] = [upward(turn), toViewer(turn)];
    // The viewer's right: the cross product of upward and towards the viewer.
    const right = [
      up[1] * out[2] - up[2] * out[1],
      up[2] * out[0] - up[0] * out[2],
      up[0] * out[1] - up[1] * out[0],
    ];
    const place = [3, -2, 1]; // y upward
    const along = (axis: readonly number[]): number =>
      axis.reduce((sum, each, i) => sum + each * (place[i] ?? 0), 0);
    near(seen(turn, [3, 2, 1]), [along(right), -along(up)]);
  });
});

describe('the viewer', () => {
  it('never goes behind the box', () => {
    expect(turned(views.front, { right: 100, above: -100 })).toEqual({ right: 90, above: -90 });
  });

  it('sees the width and height of the box from there, with room for labels', () => {
    // 10 x 8, 6 deep: from the front 10 x 8, from the side 6 x 8, each with 3 % of half the longer side around.
    const front = extent(views.front, [10, 8, 6]);
    near([front.width, front.height], [10 + 0.3, 8 + 0.3]);
    const side = extent(views.side, [10, 8, 6]);
    near([side.width, side.height], [6 + 0.24, 8 + 0.24]);
  });
});
