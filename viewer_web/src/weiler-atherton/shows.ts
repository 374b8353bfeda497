import { html, nothing } from 'lit';
import { defineShows } from '../algorithm/shows.js';
import type { Pixel } from '../picture/pixel.js';
import { layerOf, ofPolygons, pixelLayers } from '../polygons/shows.js';
import './algorithm.js';
import { allLayers } from './layers.js';
import type { RegionLayer } from './layers.js';
import './panel.js';
import { isRegionEntry, regionEntries, regionIcon } from './region-icon.js';
import './region-layers.js';
import './region-picture.js';

defineShows(['weiler-atherton'], {
  ...ofPolygons,
  state: (view, parts) =>
    html`<vidno-regions .view=${view} parts=${parts?.join(' ') ?? nothing}></vidno-regions>`,
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
