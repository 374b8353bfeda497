import { LitElement, css, html } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property, query, state } from 'lit/decorators.js';
import { allLayers } from '../floating-horizon/layers.js';
import type { Editing } from '../editor/editor.js';
import type { Exact, Layer } from '../picture/layers.js';
import type { Pixel } from '../picture/pixel.js';
import { allLayers as allRegionLayers } from '../weiler-atherton/layers.js';
import type { View } from '../algorithm/view.js';
import '../picture/legend.js';
import type { PlaneElement } from '../picture/plane.js';
import '../picture/save.js';
import type { Kind, SaveElement } from '../picture/save.js';
import { showsOf } from './shows.js';
import type { LayerChoice } from './shows.js';
import { base } from '../elements/theme.js';

/**
 * The picture, the choice of what it shows, and the legend. An event `pixel` tells that one was chosen.
 */
@customElement('vidno-picture-panel')
export class PicturePanelElement extends LitElement {
  static override styles = [
    base,
    css`
      :host {
        display: flex;
        flex-direction: column;
        min-height: 0;
      }
      .drawing {
        flex: 1;
        min-height: var(--least-picture, 0px);
      }
      .layers,
      .switches,
      vidno-legend {
        flex: none;
        display: var(--signs, var(--legend, block));
      }
      .layers,
      .switches {
        display: var(--tools, var(--legend, flex));
      }
    `,
  ];

  @property({ attribute: false }) view!: View;
  @property({ attribute: false }) editing: Editing | null = null;
  @property({ attribute: false }) layer: Layer = 'picture';
  @property({ attribute: false }) exact: Exact = null;
  /** What a picture of curves shows. */
  @state() curveLayers = allLayers;
  /** What of the regions. */
  @state() regionLayers = allRegionLayers;
  @query('.drawing') private drawing!: PlaneElement;
  @query('.layers') private choice!: LayerChoice;
  @query('vidno-save') private saver!: SaveElement;

  /** Gives the keyboard to the choice of a pixel. */
  startChoosing(): void {
    this.drawing.startChoosing();
  }

  save(kind: Kind): Promise<void> {
    return this.saver.save(kind);
  }

  nextLayer(): void {
    this.choice.next();
  }

  choose(detail: Pixel): void {
    this.dispatchEvent(new CustomEvent<Pixel>('pixel', { detail }));
  }

  override render(): TemplateResult {
    const { view } = this;
    return html`
      ${showsOf(view).picture(this)}
      <vidno-legend .view=${view}>
        <vidno-save .view=${view}></vidno-save>
      </vidno-legend>
    `;
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'vidno-picture-panel': PicturePanelElement;
  }
}
