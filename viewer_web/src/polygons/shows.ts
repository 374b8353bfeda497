import { html } from 'lit';
import type { TemplateResult } from 'lit';
import type { Pictured, Shows } from '../algorithm/shows.js';
import { layersOf } from '../picture/layers.js';
import type { Layer } from '../picture/layers.js';
import '../picture/layers-element.js';
import type { Pixel } from '../picture/pixel.js';
import './picture.js';
import './polygon-form.js';

/** The layer to show; a layer that the trace lacks is replaced. */
export const layerOf = ({ view, exact, layer }: Pictured): Layer =>
  layersOf(view.header, exact).includes(layer) ? layer : 'picture';

/** The choice of the layer that the pixels show. */
export const pixelLayers = (of: Pictured): TemplateResult =>
  html`<vidno-layers
    class="layers"
    .view=${of.view}
    .layer=${layerOf(of)}
    .exact=${of.exact}
  ></vidno-layers>`;

/** The common part of all elements for runs of polygons. */
export const ofPolygons: Omit<Shows, 'state' | 'holds' | 'legend'> = {
  picture: (of) => {
    const { view, editing, exact } = of;
    return html`<vidno-picture
        class="drawing"
        .view=${view}
        .editing=${editing}
        .layer=${layerOf(of)}
        .exact=${exact}
        @pixel=${({ detail }: CustomEvent<Pixel>) => of.choose(detail)}
      ></vidno-picture>
      ${pixelLayers(of)}`;
  },
  places: ({ history }) => history,
  form: (editing, language) =>
    html`<vidno-polygon-form .editing=${editing} .language=${language}></vidno-polygon-form>`,
  how: ({ scene }) => scene.how,
  isSolid: true,
};
