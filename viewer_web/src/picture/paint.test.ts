import { describe, expect, it } from 'vitest';
import { CellPainter } from './paint.js';
import type { Cells } from './paint.js';

/** A mock of a square canvas with the methods that a painter uses, and the pixels painted on it. */
function canvasOf(side: number): { canvas: HTMLCanvasElement; dots: Uint32Array } {
  const data = new Uint8ClampedArray(4 * side * side);
  const image = { width: side, height: side, data };
  const context = { createImageData: () => image, putImageData: () => undefined };
  const canvas = { width: side, height: side, getContext: () => context };
  return { canvas: canvas as unknown as HTMLCanvasElement, dots: new Uint32Array(data.buffer) };
}

const ink = (i: number, j: number): number => (0xff000000 | (j << 8) | i) >>> 0;

function cellsOf(side: number): { cells: Cells; asked: () => number } {
  let count = 0;
  const row = (j: number, columns: readonly number[]): readonly number[] => {
    count += columns.length;
    return columns.map((i) => ink(i, j));
  };
  return { cells: { width: side, height: side, of: [], row }, asked: () => count };
}

describe('cells on a canvas', () => {
  it('are squares at their place if they are larger than a canvas pixel, with nothing around', () => {
    const { canvas, dots } = canvasOf(8);
    new CellPainter().paint(canvas, cellsOf(2).cells, { x: 1, y: 1, scale: 3, ratio: 1 });
    const [a, b, c, d] = [ink(0, 0), ink(1, 0), ink(0, 1), ink(1, 1)];
    const row = (left: number, right: number) => [0, left, left, left, right, right, right, 0];
    const [upper, lower, none] = [row(a, b), row(c, d), row(0, 0)];
    expect([...dots]).toEqual([none, upper, upper, upper, lower, lower, lower, none].flat());
  });

  it('are read only once for each canvas pixel that shows them', () => {
    const { canvas, dots } = canvasOf(100);
    const { cells, asked } = cellsOf(16000);
    new CellPainter().paint(canvas, cells, { x: 0, y: 0, scale: 1 / 160, ratio: 1 });
    expect(asked()).toBe(100 * 100);
    // The middle of the dot at (3, 2) is at 3.5 and 2.5 times 160 cells.
    expect(dots[2 * 100 + 3]).toBe(ink(560, 400));
  });

  it('are repainted only in changed rows', () => {
    const { canvas, dots } = canvasOf(2);
    const painter = new CellPainter();
    const place = { x: 0, y: 0, scale: 1, ratio: 1 };
    const cells = (rows: readonly number[]): Cells => ({
      width: 2,
      height: 2,
      of: [rows],
      row: (j, columns) => columns.map((i) => ink(i, rows[j] ?? 0)),
    });
    painter.paint(canvas, cells([0, 1]), place);
    const stain = 0xff123456;
    dots.fill(stain);
    painter.paint(canvas, cells([0, 7]), place);
    expect([...dots]).toEqual([stain, stain, ink(0, 7), ink(1, 7)]);
  });
});
