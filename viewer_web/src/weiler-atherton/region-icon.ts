import { svg } from 'lit';
import type { SVGTemplateResult } from 'lit';
import type { LegendEntry, RegionLegendEntry } from '../language/picture-texts.js';
import { crossingData } from './shapes.js';

const box = 'M3 2.5h14v9h-14Z';

/** The icon of each entry, in a box of 20 by 14. */
const icons: Readonly<Record<RegionLegendEntry, readonly [look: string, d: string]>> = {
  clipRegion: ['clip-region', box],
  subject: ['subject', box],
  insidePart: ['inside-part', `${box}M3 11.5l9 -9M9 11.5l8 -8M3 5.5l3 -3`],
  outsidePart: ['outside-part', `${box}M17 11.5l-9 -9M11 11.5l-8 -8M17 5.5l-3 -3`],
  enters: ['enters', crossingData.enters([10, 7], 5)],
  leaves: ['leaves', crossingData.leaves([10, 7], 4)],
  shown: ['shown', box],
  piercing: ['piercing-line', 'M1 11L19 3'],
};

/** In the order of the legend. */
export const regionEntries = Object.keys(icons) as readonly RegionLegendEntry[];

export const isRegionEntry = (entry: LegendEntry): entry is RegionLegendEntry => entry in icons;

export function regionIcon(entry: RegionLegendEntry): SVGTemplateResult {
  const [look, d] = icons[entry];
  return entry === 'shown'
    ? svg`<path class=${look} d=${d} .style=${'fill: #d08a00'} />`
    : svg`<path class=${look} d=${d} />`;
}
