import type { Grid } from '../state/grid.js';

/** Where the picture stands on a canvas, in its pixels. */
export interface Place {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** The picture as an image no larger than it is shown: beyond that the nearest cells stand for all. */
function sampled(picture: Grid<number>, place: Place): ImageData {
  const width = Math.max(1, Math.min(picture.width, Math.round(place.width)));
  const height = Math.max(1, Math.min(picture.height, Math.round(place.height)));
  const image = new ImageData(width, height);
  const cells = new Uint32Array(image.data.buffer);
  for (let j = 0; j < height; j++) {
    const row = picture.row(Math.floor(((j + 0.5) * picture.height) / height));
    for (let i = 0; i < width; i++) {
      cells[j * width + i] = row[Math.floor(((i + 0.5) * picture.width) / width)] ?? 0;
    }
  }
  return image;
}

/** Paints the picture, each of its pixels a sharp square. */
export function paint(canvas: HTMLCanvasElement, picture: Grid<number>, place: Place): void {
  const context = canvas.getContext('2d');
  if (context === null || place.width < 1 || place.height < 1) return;
  const image = sampled(picture, place);
  const small = document.createElement('canvas');
  small.width = image.width;
  small.height = image.height;
  small.getContext('2d')?.putImageData(image, 0, 0);
  context.clearRect(0, 0, canvas.width, canvas.height);
  context.imageSmoothingEnabled = false;
  context.drawImage(small, place.x, place.y, place.width, place.height);
}
