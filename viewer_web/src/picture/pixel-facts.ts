import { isPainted, toColor } from '../replay/grid.js';
import type { Screen } from '../replay/screen.js';
import type { N } from '../trace/values.js';
import type { Pixel } from './pixel.js';

/** What is known of a pixel at a step. */
export interface PixelFacts {
  /** Null where nothing was painted yet. */
  readonly color: string | null;
  readonly isBackground: boolean;
  /** The polygons of that colour: which of them it was the picture does not say. */
  readonly polygons: readonly string[];
  /** What the Z-buffer holds, where there is one. */
  readonly depth: N | null;
}

export function factsAt({ picture, z, scene }: Screen, [x, y]: Pixel): PixelFacts {
  const [i, j] = [x - scene.area.x, y - scene.area.y];
  const pixel = picture.at(i, j);
  const color = isPainted(pixel) ? toColor(pixel) : null;
  const polygons = scene.polygons.filter((each) => each.color === color).map(({ id }) => id);
  const isBackground = color === scene.background;
  return { color, isBackground, polygons, depth: z?.at(i, j) ?? null };
}
