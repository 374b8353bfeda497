import { html, nothing } from 'lit';
import { defineShows } from '../algorithm/shows.js';
import type { Pixel } from '../picture/pixel.js';
import './algorithm.js';
import { curveEntries, curveIcon, isCurveEntry } from './curve-icon.js';
import './curve-layers.js';
import './curve-picture.js';
import { allLayers } from './layers.js';
import type { Layer } from './layers.js';
import './panel.js';
import './surface-form.js';

defineShows(['floating-horizon'], {
  state: (view, parts) =>
    html`<vidno-horizon .view=${view} parts=${parts?.join(' ') ?? nothing}></vidno-horizon>`,
  legend: curveEntries,
  icon: (entry) => (isCurveEntry(entry) ? curveIcon(entry) : null),
  picture: (of) => {
    const shown = of.shownOf(allLayers);
    return html`<vidno-curve-picture
        class="drawing"
        .view=${of.view}
        .layers=${shown}
        ?edited=${of.editing !== null}
        @pixel=${({ detail }: CustomEvent<Pixel>) => of.choose(detail)}
      ></vidno-curve-picture>
      <vidno-curve-layers
        class="layers"
        .view=${of.view}
        .layers=${shown}
        @layers=${({ detail }: CustomEvent<ReadonlySet<Layer>>) => of.show(detail, allLayers)}
      ></vidno-curve-layers>`;
  },
  places: ({ history, curves }) => ({ ...history, ...curves.history }),
  form: (editing, language) =>
    html`<vidno-surface-form .editing=${editing} .language=${language}></vidno-surface-form>`,
  how: ({ curves }) => curves.surface.how,
  isSolid: false,
});
