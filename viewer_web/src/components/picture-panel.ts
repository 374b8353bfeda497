import { LitElement, css, html } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property, query } from 'lit/decorators.js';
import type { Editing } from '../live/editor.js';
import { layersOf } from '../picture/layers.js';
import type { Exact, Layer } from '../picture/layers.js';
import type { Pixel } from '../picture/pixel.js';
import type { View } from '../view.js';
import { askForLayer } from './layers.js';
import './legend.js';
import './picture.js';
import type { PictureElement } from './picture.js';
import './save.js';
import type { Kind, SaveElement } from './save.js';
import { base } from './theme.js';

/**
 * The picture, the choice of what its pixels show, and the legend. Instead of a layer that the trace has not the picture so
 * far is shown. An event `pixel` tells that one was chosen.
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
      vidno-picture {
        flex: 1;
        min-height: 0;
      }
      vidno-layers,
      vidno-legend {
        flex: none;
        display: var(--signs, var(--legend, block));
      }
      vidno-layers {
        display: var(--tools, var(--legend, flex));
      }
    `,
  ];

  @property({ attribute: false }) view!: View;
  @property({ attribute: false }) editing: Editing | null = null;
  @property({ attribute: false }) layer: Layer = 'picture';
  @property({ attribute: false }) exact: Exact = null;
  @query('vidno-picture') private picture!: PictureElement;
  @query('vidno-save') private saver!: SaveElement;

  /** Gives the keyboard to the choice of a pixel. */
  startChoosing(): void {
    this.picture.startChoosing();
  }

  save(kind: Kind): Promise<void> {
    return this.saver.save(kind);
  }

  nextLayer(): void {
    const all = this.layers;
    const next = all[(all.indexOf(this.shown) + 1) % all.length];
    if (next !== undefined && next !== this.shown) askForLayer(this, next);
  }

  private get layers(): readonly Layer[] {
    return layersOf(this.view.header, this.exact);
  }

  private get shown(): Layer {
    return this.layers.includes(this.layer) ? this.layer : 'picture';
  }

  private choose(detail: Pixel): void {
    this.dispatchEvent(new CustomEvent<Pixel>('pixel', { detail }));
  }

  override render(): TemplateResult {
    const { view, editing, exact, shown } = this;
    return html`
      <vidno-picture
        .view=${view}
        .editing=${editing}
        .layer=${shown}
        .exact=${exact}
        @pixel=${({ detail }: CustomEvent<Pixel>) => this.choose(detail)}
      ></vidno-picture>
      <vidno-layers .view=${view} .layer=${shown} .exact=${exact}></vidno-layers>
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
