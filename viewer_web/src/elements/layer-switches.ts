import { LitElement, css, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { property } from 'lit/decorators.js';
import type { View } from '../algorithm/view.js';
import { base } from './theme.js';

/** The names of the layers, together and each. */
interface LayerNames<L extends string> {
  readonly layersName: string;
  readonly layers: Readonly<Record<L, string>>;
}

/** Switches for the layers of a picture. An event `layers` carries the new choice. */
export abstract class LayerSwitches<L extends string> extends LitElement {
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
  @property({ attribute: false }) layers: ReadonlySet<L> = new Set();

  protected abstract readonly all: readonly L[];
  /** The key that switches all of them, if there is one. */
  protected readonly key: string | null = null;

  protected abstract get names(): LayerNames<L>;

  protected show(detail: ReadonlySet<L>): void {
    this.dispatchEvent(new CustomEvent<ReadonlySet<L>>('layers', { detail }));
  }

  private toggle(layer: L): void {
    this.show(new Set(this.all.filter((each) => this.layers.has(each) !== (each === layer))));
  }

  override render(): TemplateResult {
    const { names } = this;
    return html`<div
      role="group"
      aria-label=${names.layersName}
      aria-keyshortcuts=${this.key ?? nothing}
    >
      ${this.all.map(
        (layer) =>
          html`<label
            ><input
              type="checkbox"
              name=${layer}
              .checked=${this.layers.has(layer)}
              @change=${() => this.toggle(layer)}
            />${names.layers[layer]}</label
          >`,
      )}
    </div>`;
  }
}
