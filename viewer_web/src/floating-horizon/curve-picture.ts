import { css, html, nothing, svg } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { guard } from 'lit/directives/guard.js';
import { LayerSwitches } from '../elements/layer-switches.js';
import { base, hiddenStyle } from '../elements/theme.js';
import { texts } from '../i18n/index.js';
import type { CurveHistoryTexts, CurveTexts } from '../language/texts.js';
import { curvesStyle } from '../picture/curves.style.js';
import { drawn } from '../picture/drawn.js';
import type { Frame, Point } from '../picture/frame.js';
import { marksStyle } from '../picture/marks.style.js';
import { pictureStyle } from '../picture/picture.style.js';
import type { Pixel } from '../picture/pixel.js';
import { PlaneElement } from '../picture/plane.js';
import type { Layer } from './shapes.js';
import './sample-handles.js';
import {
  allLayers,
  columnShape,
  curveLayers,
  curveShapes,
  curvesToPoint,
  linesAlone,
} from './shapes.js';

/** The lines drawn so far, and over them the state of the procedure: curves and columns. */
@customElement('vidno-curve-picture')
export class CurvePictureElement extends PlaneElement {
  static override styles = [
    base,
    hiddenStyle,
    marksStyle,
    pictureStyle,
    curvesStyle,
    css`
      /* White paper in every theme, also beside the area: the curves are black. */
      :host {
        forced-color-adjust: none;
        background: #ffffff;
      }
      vidno-zoom-bar {
        forced-color-adjust: auto;
      }
      vidno-axes {
        --well: #ffffff;
        --soft: #566070;
        --ink: #171b24;
        --forced-paper: #ffffff;
        --forced-ink: #000000;
      }
    `,
  ];

  @property({ attribute: false }) layers: ReadonlySet<Layer> = allLayers;
  /** Whether samples can be moved. */
  @property({ type: Boolean }) edited = false;

  protected override above(frame: Frame): unknown {
    if (!this.edited) return nothing;
    return html`<vidno-sample-handles
      .view=${this.view}
      .frame=${frame}
      @follow=${({ detail }: CustomEvent<Point>) => this.follow(detail, 0)}
    ></vidno-sample-handles>`;
  }

  /** A sample lies over a whole column, and heights are whole at the lines. */
  protected override readonly numbered = 'lines';

  protected override get words(): CurveHistoryTexts {
    return texts[this.view.language].curves.history;
  }

  protected override spoken([x]: Pixel): string {
    const { columns, header } = this.view;
    const at = this.words.at(x);
    if (columns === null || header.detail === 'windows') return at;
    const i = x - header.scene.area.x;
    const { upper, lower } = columns.horizons;
    return `${at}: ${this.words.horizons(upper[i] ?? null, lower[i] ?? null)}`;
  }

  protected override drawing(frame: Frame): unknown {
    const { view, layers } = this;
    const { curves } = view.header.scene;
    return svg`${curveShapes(view, frame, layers).map(drawn)}
      ${guard([curves], () => curvesToPoint(curves ?? []).map(drawn))}`;
  }

  protected override cursorMark([x]: Pixel): unknown {
    return drawn(columnShape('cursor', x, this.view.header.scene.area));
  }

  /** The nearest column, as a column is a line of the plane and not a square. */
  protected override placeAt(point: Point): Pixel {
    const { x: first, y: top, width, height } = this.view.header.scene.area;
    const [x, y] = this.frame.at(...point);
    const isInside = y >= top && y < top + height && x > first - 1 && x < first + width;
    if (!isInside) return [first - 1, top];
    return [Math.min(Math.max(Math.round(x), first), first + width - 1), Math.floor(y)];
  }
}

/** The layers of the picture of curves. */
@customElement('vidno-curve-layers')
export class CurveLayersElement extends LayerSwitches<Layer> {
  protected override readonly all = curveLayers;
  protected override readonly key = 'L';

  protected override get names(): CurveTexts {
    return texts[this.view.language].curves;
  }

  /** Switches between the lines alone and everything. */
  next(): void {
    this.show(this.layers.size === 1 && this.layers.has('lines') ? allLayers : linesAlone);
  }
}
