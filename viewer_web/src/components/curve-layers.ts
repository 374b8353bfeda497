import { LitElement, css, html } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { allLayers, curveLayers, linesAlone, switched } from '../curves/layers.js';
import type { Layer } from '../curves/layers.js';
import { texts } from '../i18n/index.js';
import type { View } from '../view.js';
import { base } from './theme.js';

/** Switches for what the picture of curves shows: an event `layers` tells what is to be shown. */
@customElement('vidno-curve-layers')
export class CurveLayersElement extends LitElement {
  static override styles = [
    base,
    css`
      :host {
        display: flex;
        align-items: center;
        min-height: 2.75rem;
        padding: 0.25rem 0.75rem;
        border-top: 1px solid var(--line);
        font-size: 0.75rem;
        color: var(--soft);
      }
      div {
        display: flex;
        flex-wrap: wrap;
        gap: 0.1rem 0.9rem;
      }
      label {
        display: flex;
        gap: 0.3rem;
        align-items: center;
        min-height: 1.5rem;
        white-space: nowrap;
      }
      input {
        margin: 0;
        accent-color: var(--accent);
      }
    `,
  ];

  @property({ attribute: false }) view!: View;
  @property({ attribute: false }) layers: ReadonlySet<Layer> = new Set();

  /** The lines alone, and everything again. */
  next(): void {
    this.show(this.layers.size === 1 && this.layers.has('lines') ? allLayers : linesAlone);
  }

  private show(detail: ReadonlySet<Layer>): void {
    this.dispatchEvent(new CustomEvent<ReadonlySet<Layer>>('layers', { detail }));
  }

  override render(): TemplateResult {
    const { curves } = texts[this.view.language];
    return html`<div role="group" aria-label=${curves.layersName} aria-keyshortcuts="L">
      ${curveLayers.map(
        (layer) =>
          html`<label
            ><input
              type="checkbox"
              name=${layer}
              .checked=${this.layers.has(layer)}
              @change=${() => this.show(switched(this.layers, layer))}
            />${curves.layers[layer]}</label
          >`,
      )}
    </div>`;
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'vidno-curve-layers': CurveLayersElement;
  }
}
