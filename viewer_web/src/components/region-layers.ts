import { LitElement, html } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { texts } from '../i18n/index.js';
import { regionLayers, switched } from '../regions/layers.js';
import type { RegionLayer } from '../regions/layers.js';
import type { View } from '../view.js';
import { CurveLayersElement } from './curve-layers.js';

/** Switches for what the picture of regions shows: an event `layers` tells what is to be shown. */
@customElement('vidno-region-layers')
export class RegionLayersElement extends LitElement {
  static override styles = CurveLayersElement.styles;

  @property({ attribute: false }) view!: View;
  @property({ attribute: false }) layers: ReadonlySet<RegionLayer> = new Set();

  private toggle(layer: RegionLayer): void {
    const detail = switched(this.layers, layer);
    this.dispatchEvent(new CustomEvent<ReadonlySet<RegionLayer>>('layers', { detail }));
  }

  override render(): TemplateResult {
    const { regions } = texts[this.view.language];
    return html`<div role="group" aria-label=${regions.layersName}>
      ${regionLayers.map(
        (layer) =>
          html`<label
            ><input
              type="checkbox"
              name=${layer}
              .checked=${this.layers.has(layer)}
              @change=${() => this.toggle(layer)}
            />${regions.layers[layer]}</label
          >`,
      )}
    </div>`;
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'vidno-region-layers': RegionLayersElement;
  }
}
