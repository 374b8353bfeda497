import { html } from 'lit';
import type { TemplateResult } from 'lit';
import type { Layer as CurveLayer } from '../floating-horizon/layers.js';
import { texts } from '../i18n/index.js';
import type { Language } from '../language/language.js';
import type { HistoryTexts, Texts } from '../language/texts.js';
import type { Editing } from '../editor/editor.js';
import { layersOf } from '../picture/layers.js';
import type { Exact, Layer } from '../picture/layers.js';
import type { Pixel } from '../picture/pixel.js';
import type { RegionLayer } from '../weiler-atherton/layers.js';
import type { Method } from '../trace/events.js';
import { methodKindOf } from '../trace/method-kind.js';
import type { MethodKind } from '../trace/method-kind.js';
import type { View } from '../algorithm/view.js';
import '../floating-horizon/curve-layers.js';
import '../floating-horizon/curve-picture.js';
import '../floating-horizon/panel.js';
import '../picture/layers-element.js';
import '../polygons/picture.js';
import '../polygons/polygon-form.js';
import '../weiler-atherton/region-layers.js';
import '../weiler-atherton/region-picture.js';
import '../weiler-atherton/panel.js';
import '../floating-horizon/surface-form.js';
import '../warnock/panel.js';
import '../zbuffer/panel.js';

/** Where one chooses what a picture shows. */
export interface LayerChoice extends HTMLElement {
  /** The next of what there is to choose. */
  next(): void;
}

/** What a picture is made of. */
interface Pictured {
  readonly view: View;
  readonly editing: Editing | null;
  readonly layer: Layer;
  readonly exact: Exact;
  curveLayers: ReadonlySet<CurveLayer>;
  regionLayers: ReadonlySet<RegionLayer>;
  choose(place: Pixel): void;
}

/** What the page shows of a run, where that depends on what the run is of. */
export interface Shows {
  /** The panel of its state. */
  readonly state: (view: View) => TemplateResult;
  /** The picture, and the choice of what it shows; their classes are `drawing` and `layers`. */
  readonly picture: (pictured: Pictured) => TemplateResult;
  /** What is said of a place that is chosen in the picture: a pixel, or a column. */
  readonly places: (texts: Texts) => HistoryTexts;
  /** The form of the scene that is run. */
  readonly form: (editing: Editing, language: Language) => TemplateResult;
  /** What can be done with the scene, in words. */
  readonly how: (texts: Texts) => string;
  /** Whether the scene has polygons, which may be drawn, and shown in 3D. */
  readonly isSolid: boolean;
}

/** A layer that the trace has not is not shown. */
const layerOf = ({ view, exact, layer }: Pictured): Layer =>
  layersOf(view.header, exact).includes(layer) ? layer : 'picture';

/** The choice of what the pixels show. */
const pixelLayers = (of: Pictured): TemplateResult =>
  html`<vidno-layers
    class="layers"
    .view=${of.view}
    .layer=${layerOf(of)}
    .exact=${of.exact}
  ></vidno-layers>`;

const ofPolygons: Omit<Shows, 'state'> = {
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

const shows: Readonly<Record<MethodKind, Shows>> = {
  windows: { ...ofPolygons, state: (view) => html`<vidno-warnock .view=${view}></vidno-warnock>` },
  scanlines: {
    ...ofPolygons,
    state: (view) => html`<vidno-zbuffer .view=${view}></vidno-zbuffer>`,
  },
  curves: {
    state: (view) => html`<vidno-horizon .view=${view}></vidno-horizon>`,
    picture: (of) =>
      html`<vidno-curve-picture
          class="drawing"
          .view=${of.view}
          .layers=${of.curveLayers}
          ?edited=${of.editing !== null}
          @pixel=${({ detail }: CustomEvent<Pixel>) => of.choose(detail)}
        ></vidno-curve-picture>
        <vidno-curve-layers
          class="layers"
          .view=${of.view}
          .layers=${of.curveLayers}
          @layers=${({ detail }: CustomEvent<ReadonlySet<CurveLayer>>) => (of.curveLayers = detail)}
        ></vidno-curve-layers>`,
    places: ({ history, curves }) => ({ ...history, ...curves.history }),
    form: (editing, language) =>
      html`<vidno-surface-form .editing=${editing} .language=${language}></vidno-surface-form>`,
    how: ({ curves }) => curves.surface.how,
    isSolid: false,
  },
  regions: {
    ...ofPolygons,
    state: (view) => html`<vidno-regions .view=${view}></vidno-regions>`,
    picture: (of) => {
      const { view, editing, exact, regionLayers } = of;
      return html`<vidno-region-picture
          class="drawing"
          .view=${view}
          .editing=${editing}
          .layer=${layerOf(of)}
          .exact=${exact}
          .shown=${regionLayers}
          @pixel=${({ detail }: CustomEvent<Pixel>) => of.choose(detail)}
        ></vidno-region-picture>
        <vidno-region-layers
          class="switches"
          .view=${view}
          .layers=${regionLayers}
          @layers=${({ detail }: CustomEvent<ReadonlySet<RegionLayer>>) => (of.regionLayers = detail)}
        ></vidno-region-layers>
        ${pixelLayers(of)}`;
    },
  },
};

const showsOfMethod = (method: Method): Shows => shows[methodKindOf(method)];

export const showsOf = ({ header }: Pick<View, 'header'>): Shows => showsOfMethod(header.method);

/** The same of a scene that is edited. */
export const showsOfEdited = ({ options }: Editing): Shows => showsOfMethod(options.method);

/** What is said of places in the picture of a view, in its language. */
export const placesOf = (view: View): HistoryTexts => showsOf(view).places(texts[view.language]);
