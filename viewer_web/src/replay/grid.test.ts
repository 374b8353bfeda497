import { describe, expect, it } from 'vitest';
import { Grid } from './grid.js';

const gridOf = (width: number, height: number): Grid<number> =>
  new Grid<number>(width, height, 0, (n) => new Uint32Array(n));

describe('a grid', () => {
  it('keeps written cells, independent of snapshots, in rows of one piece and of many', () => {
    for (const width of [1, 7, 256, 257, 700]) {
      const grid = gridOf(width, 5);
      const right = Array.from({ length: 5 }, () => new Array<number>(width).fill(0));
      const rows = (): number[][] => right.map((_, j) => Array.from(grid.row(j)));
      const put = (x: number, y: number, across: number, down: number, value: number): void => {
        const end = Math.min(x + across, width);
        if (end > x) grid.fill(x, y, end - x, down, value);
        for (const row of right.slice(y, y + down)) if (end > x) row.fill(value, x, end);
      };
      put(0, 1, width, 2, 3);
      put(2, 0, 300, 4, 5);
      put(255, 2, 2, 3, 6);
      const saved = grid.save();
      const before = right.map((row) => [...row]);
      grid.set(width - 1, 4, 9);
      right[4]?.splice(width - 1, 1, 9);
      put(1, 1, 520, 4, 8);
      expect(rows()).toEqual(right);
      expect(right.map((row, j) => row.map((_, i) => grid.at(i, j)))).toEqual(right);
      grid.load(saved);
      expect(rows()).toEqual(before);
    }
  });

  it('of a large area is quickly painted in rectangles', () => {
    const side = 16384;
    const start = performance.now();
    const grid = gridOf(side, side);
    for (let i = 0; i < 40; i++) {
      grid.fill(100 + i, 100, side / 2, side / 2, i);
      grid.save();
    }
    // Copying everything, a quarter of the area takes a gigabyte each time.
    expect(performance.now() - start).toBeLessThan(8000);
    expect(grid.at(100 + 39, 100)).toBe(39);
    expect(grid.at(99 + 39, 100)).toBe(38);
    expect(grid.at(100 + 39 + side / 2, 100)).toBe(0);
  });
});
