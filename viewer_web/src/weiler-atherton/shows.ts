import { html, nothing, svg } from 'lit';
import type { SVGTemplateResult } from 'lit';
import { defineShows } from '../algorithm/shows.js';
import type { LegendEntry } from '../language/texts.js';
import type { Pixel } from '../picture/pixel.js';
import { layerOf, ofPolygons, pixelLayers } from '../polygons/shows.js';
import './algorithm.js';
import { allLayers, crossingData } from './shapes.js';
import type { RegionLayer } from './shapes.js';
import './panel.js';
import './region-picture.js';

const box = 'M3 2.5h14v9h-14Z';

/** The icon of each entry, in a box of 20 by 14. */
const icons = {
  clipRegion: ['clip-region', box],
  subject: ['subject', box],
  insidePart: ['inside-part', `${box}M3 11.5l9 -9M9 11.5l8 -8M3 5.5l3 -3`],
  outsidePart: ['outside-part', `${box}M17 11.5l-9 -9M11 11.5l-8 -8M17 5.5l-3 -3`],
  enters: ['enters', crossingData.enters([10, 7], 5)],
  leaves: ['leaves', crossingData.leaves([10, 7], 4)],
  shown: ['shown', box],
  piercing: ['piercing-line', 'M1 11L19 3'],
} as const satisfies Partial<Record<LegendEntry, readonly [look: string, d: string]>>;

type RegionLegendEntry = keyof typeof icons;

/** In the order of the legend. */
const regionEntries = Object.keys(icons) as readonly RegionLegendEntry[];

const isRegionEntry = (entry: LegendEntry): entry is RegionLegendEntry => entry in icons;

function regionIcon(entry: RegionLegendEntry): SVGTemplateResult {
  const [look, d] = icons[entry];
  return entry === 'shown'
    ? svg`<path class=${look} d=${d} .style=${'fill: #d08a00'} />`
    : svg`<path class=${look} d=${d} />`;
}

defineShows(['weiler-atherton'], {
  ...ofPolygons,
  state: (view, parts) =>
    html`<vidno-regions
      .view=${view}
      ?hall=${view.hall}
      parts=${parts?.join(' ') ?? nothing}
    ></vidno-regions>`,
  holds: () => ['list', 'parts', 'visible'],
  legend: [...regionEntries, 'touched', 'chosen'],
  icon: (entry) => (isRegionEntry(entry) ? regionIcon(entry) : null),
  picture: (of) => {
    const { view, editing, exact } = of;
    const shown = of.shownOf(allLayers);
    return html`<vidno-region-picture
        class="drawing"
        .view=${view}
        .editing=${editing}
        .layer=${layerOf(of)}
        .exact=${exact}
        .shown=${shown}
        @pixel=${({ detail }: CustomEvent<Pixel>) => of.choose(detail)}
      ></vidno-region-picture>
      <vidno-region-layers
        class="switches"
        .view=${view}
        .layers=${shown}
        @layers=${({ detail }: CustomEvent<ReadonlySet<RegionLayer>>) => of.show(detail, allLayers)}
      ></vidno-region-layers>
      ${pixelLayers(of)}`;
  },
});
