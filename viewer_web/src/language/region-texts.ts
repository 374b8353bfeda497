import type { Region } from '../weiler-atherton/events.js';
import { boundsOf, verticesOf } from '../weiler-atherton/geometry.js';
import type { RegionLayer } from '../weiler-atherton/layers.js';
import type { RegionEvents } from '../trace/events.js';
import { point, toNumber } from './words.js';
import type { PluralForms, Words } from './words.js';

/** What a run with regions has to say of its own. */
export interface RegionTexts {
  readonly lists: string;
  readonly list: string;
  readonly clip: string;
  readonly ground: string;
  readonly inside: string;
  readonly outside: string;
  readonly behind: string;
  readonly nearer: string;
  readonly visible: string;
  /** How many of these there are. */
  readonly shown: string;
  readonly area: string;
  readonly vertices: PluralForms;
  readonly pieces: string;
  readonly loops: PluralForms;
  readonly layers: Readonly<Record<RegionLayer, string>>;
  readonly layersName: string;
}

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
export function boxOf(region: Region): string {
  const { from, to } = boundsOf(region);
  const isSomewhere = region.flat(2).every((value) => Number.isFinite(toNumber(value)));
  return isSomewhere ? `, ${point(from)} – ${point(to)}` : '';
}

export type RegionSentences = {
  readonly [K in Exclude<keyof RegionEvents, 'row'>]: (
    event: RegionEvents[K],
    words: Words,
  ) => string;
};
