import type { Grid } from '../state/grid.js';

/** Where a picture lies on a canvas, in dots of the device. */
export interface Place {
  /** The corner of its first pixel, which may be off the canvas. */
  readonly x: number;
  readonly y: number;
  /** The side of a pixel. */
  readonly scale: number;
}

const none = -1;

/** The cell that the middle of each dot lies in. */
function cellsOf(dots: number, from: number, scale: number, cells: number): readonly number[] {
  return Array.from({ length: dots }, (_, dot) => {
    const cell = Math.floor((dot + 0.5 - from) / scale);
    return cell >= 0 && cell < cells ? cell : none;
  });
}

/** Paints the picture dot by dot: each of its pixels is a sharp square, at most half a dot from its place. */
export function paint(canvas: HTMLCanvasElement, picture: Grid<number>, place: Place): void {
  const { width, height } = canvas;
  const context = canvas.getContext('2d');
  if (context === null || width === 0 || height === 0) return;
  const image = context.createImageData(width, height);
  const dots = new Uint32Array(image.data.buffer);
  const columns = cellsOf(width, place.x, place.scale, picture.width);
  let last = none;
  cellsOf(height, place.y, place.scale, picture.height).forEach((j, y) => {
    const start = y * width;
    if (j === last) dots.copyWithin(start, start - width, start);
    else if (j !== none) {
      const row = picture.row(j);
      columns.forEach((i, x) => {
        if (i !== none) dots[start + x] = row[i] ?? 0;
      });
    }
    last = j;
  });
  context.putImageData(image, 0, 0);
}
