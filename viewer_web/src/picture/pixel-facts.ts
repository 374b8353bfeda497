import { isPainted, toColor } from '../replay/grid.js';
import type { Screen } from '../replay/screen.js';
import { planeOf } from '../trace/plane.js';
import type { N } from '../trace/values.js';
import type { Pixel } from './pixel.js';

/** The facts about a pixel at a step. */
export interface PixelFacts {
  /** Null if nothing was painted yet. */
  readonly color: string | null;
  readonly isBackground: boolean;
  /** The polygons with that colour; the picture does not determine which of them it was. */
  readonly polygons: readonly string[];
  /** The depth in the Z-buffer; without one, that of the polygon's plane at the centre, in ordinary numbers. */
  readonly depth: N | null;
  readonly isStored: boolean;
}

export function factsAt({ picture, z, scene }: Screen, [x, y]: Pixel): PixelFacts {
  const [i, j] = [x - scene.area.x, y - scene.area.y];
  const pixel = picture.at(i, j);
  const color = isPainted(pixel) ? toColor(pixel) : null;
  const polygons = scene.polygons.filter((each) => each.color === color).map(({ id }) => id);
  const isBackground = color === scene.background;
  const stored = z?.at(i, j) ?? null;
  const [id, ...others] = isBackground ? [] : polygons;
  const owner = id === undefined || others.length > 0 ? undefined : scene.byId.get(id);
  const computed = owner === undefined ? NaN : planeOf(owner)(x + 0.5, y + 0.5);
  const depth = stored ?? (Number.isFinite(computed) ? computed : null);
  return { color, isBackground, polygons, depth, isStored: stored !== null };
}
