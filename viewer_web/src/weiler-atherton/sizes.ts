import type { RegionTexts } from '../language/region-texts.js';
import { toNumber } from '../language/words.js';
import type { PluralForms, Words } from '../language/words.js';
import type { Region } from './events.js';
import { boundsOf, verticesOf } from './geometry.js';

/** "8 vertices, 2 loops". */
export function sized(
  region: Region,
  { vertices, loops }: Pick<RegionTexts, 'vertices' | 'loops'>,
  counted: (n: number, forms: PluralForms) => string,
): string {
  const size = counted(verticesOf(region), vertices);
  return region.length > 1 ? `${size}, ${counted(region.length, loops)}` : size;
}

/** The corners of a region's bounding box, after a comma; empty if rounding has made a vertex non-finite. */
export function boxOf(region: Region, { point }: Pick<Words, 'point'>): string {
  const { from, to } = boundsOf(region);
  const isSomewhere = region.flat(2).every((value) => Number.isFinite(toNumber(value)));
  return isSomewhere ? `, ${point(from)} – ${point(to)}` : '';
}
