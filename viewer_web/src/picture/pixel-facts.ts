import { nobody } from '../algorithm/owners.js';
import type { Owners } from '../algorithm/owners.js';
import type { View } from '../algorithm/view.js';
import { isPainted, toColor } from '../replay/screen.js';
import type { Screen } from '../replay/screen.js';
import { isMistake } from '../trace/editions.js';
import type { Edition } from '../trace/editions.js';
import { planeOf } from '../trace/polygon.js';
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

/** The facts about a pixel in a view. */
export const factsIn = (
  { screen, ownersAt, header }: Pick<View, 'screen' | 'ownersAt' | 'header'>,
  at: Pixel,
): PixelFacts => factsAt(screen, at, ownersAt(at), header.edition);

/**
 * The owners are those of the pixel; null if it is not painted. A usual mistake may give the polygons other depths than the
 * scene: then only stored ones are known.
 */
export function factsAt(
  { picture, z, scene, isGround }: Screen,
  [x, y]: Pixel,
  owners: Owners | null,
  edition: Edition = 'corrected',
): PixelFacts {
  const [i, j] = [x - scene.area.x, y - scene.area.y];
  const pixel = picture.at(i, j);
  const stored = z?.at(i, j) ?? null;
  const known = owners ?? (isGround ? { ...nobody, background: true } : nobody);
  const [id, ...others] = known.background ? [] : known.polygons;
  const owner = id === undefined || others.length > 0 ? undefined : scene.byId.get(id);
  const computed =
    owner === undefined || isMistake(edition) ? NaN : planeOf(owner)(x + 0.5, y + 0.5);
  return {
    color: isPainted(pixel) || isGround ? toColor(pixel) : null,
    owners: known,
    depth: stored ?? (Number.isFinite(computed) ? computed : null),
    isStored: stored !== null,
  };
}
