import { nobody } from '../algorithm/owners.js';
import type { Owners } from '../algorithm/owners.js';
import { isPainted, toColor } from '../replay/grid.js';
import type { Screen } from '../replay/screen.js';
import { planeOf } from '../trace/plane.js';
import type { N } from '../trace/values.js';
import type { Pixel } from './pixel.js';

/** The facts about a pixel at a step. */
export interface PixelFacts {
  /** Null if nothing was painted yet. */
  readonly color: string | null;
  readonly owners: Owners;
  /** The depth in the Z-buffer; without one, that of the polygon's plane at the centre, in ordinary numbers. */
  readonly depth: N | null;
  readonly isStored: boolean;
}

/** The owners are those of the pixel; null if it is not painted. */
export function factsAt(
  { picture, z, scene }: Screen,
  [x, y]: Pixel,
  owners: Owners | null,
): PixelFacts {
  const [i, j] = [x - scene.area.x, y - scene.area.y];
  const pixel = picture.at(i, j);
  const stored = z?.at(i, j) ?? null;
  const known = owners ?? nobody;
  const [id, ...others] = known.background ? [] : known.polygons;
  const owner = id === undefined || others.length > 0 ? undefined : scene.byId.get(id);
  const computed = owner === undefined ? NaN : planeOf(owner)(x + 0.5, y + 0.5);
  return {
    color: isPainted(pixel) ? toColor(pixel) : null,
    owners: known,
    depth: stored ?? (Number.isFinite(computed) ? computed : null),
    isStored: stored !== null,
  };
}
