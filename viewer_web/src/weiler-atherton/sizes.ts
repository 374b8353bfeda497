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

/** The corners of the box around a region, after a comma; nothing where rounding has left a vertex nowhere. */
export function boxOf(region: Region, { point }: Pick<Words, 'point'>): string {
  const { from, to } = boundsOf(region);
  const isSomewhere = region.flat(2).every((value) => Number.isFinite(toNumber(value)));
  return isSomewhere ? `, ${point(from)} – ${point(to)}` : '';
}
