import { LitElement, css, html, nothing, unsafeCSS } from 'lit';
import type { PropertyValues, TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { texts } from '../i18n/index.js';
import type { PictureTexts } from '../language/texts.js';
import { depthRange, differenceOf, known, layersOf, needsExact } from './layers.js';
import type { Difference, Exact, Layer } from './layers.js';
import { stops } from './ramp.js';
import { numbersOf } from '../algorithm/view.js';
import type { View } from '../algorithm/view.js';
import { textureStyle } from './picture.style.js';
import { base, hiddenStyle } from '../elements/theme.js';

/** Requests another layer from the owner of the player. */
export function askForLayer(from: EventTarget, detail: Layer): void {
  from.dispatchEvent(new CustomEvent('vidno-layer', { detail, bubbles: true, composed: true }));
}

/** The choice of the layer that the pixels show, and its meaning. */
@customElement('vidno-layers')
export class LayersElement extends LitElement {
  static override styles = [
    base,
    hiddenStyle,
    textureStyle,
    css`
      :host {
        position: relative;
        display: flex;
        gap: 0.6rem;
        align-items: center;
        min-height: var(--foot, 2.25rem);
        padding: 0 0.5rem 0 0;
        font-size: 0.75rem;
        line-height: 1.3;
        color: var(--soft);
      }
      select {
        visibility: var(--quiet, visible);
        width: 8.5rem;
        min-height: 1.5rem;
        padding: 0 0.3rem;
        font-size: 0.8125rem;
        color: var(--ink);
        text-overflow: ellipsis;
      }
      .status {
        max-height: 100%;
        overflow: hidden;
      }
      .depths {
        display: flex;
        gap: 0.4rem;
        align-items: center;
        white-space: nowrap;
      }
      .ramp {
        flex: 1;
        min-width: 2rem;
        max-width: 12rem;
        height: 0.75rem;
        border-radius: 2px;
        background: linear-gradient(to right, ${unsafeCSS(stops.join(', '))});
      }
      .difference > span {
        display: inline-block;
        margin-right: 0.75rem;
        white-space: nowrap;
      }
    `,
  ];

  @property({ attribute: false }) view!: View;
  @property({ attribute: false }) layer: Layer = 'picture';
  @property({ attribute: false }) exact: Exact = null;

  /** The last announcement, made when another layer is shown and not at every step. */
  private said = '';

  private get say(): PictureTexts {
    return texts[this.view.language].picture;
  }

  override willUpdate(changed: PropertyValues<this>): void {
    const { say, layer } = this;
    const isOther = changed.get('layer') !== undefined;
    const isThere = changed.has('exact') && needsExact(layer);
    if (isOther || isThere) this.said = `${say.layers[layer]}: ${this.words()}`;
  }

  override render(): TemplateResult {
    const { say, layer, exact } = this;
    return html`
      <select
        aria-label=${say.layer}
        aria-keyshortcuts="L"
        .value=${layer}
        @change=${this.onChoose}
      >
        ${layersOf(this.view.header, exact).map(
          (each) =>
            html`<option value=${each} ?selected=${each === layer}>${say.layers[each]}</option>`,
        )}
      </select>
      ${this.status()}
      <p class="heard" aria-live="polite">${this.said}</p>
    `;
  }

  next(): void {
    const all = layersOf(this.view.header, this.exact);
    const next = all[(all.indexOf(this.layer) + 1) % all.length];
    if (next !== undefined && next !== this.layer) askForLayer(this, next);
  }

  private onChoose(event: Event): void {
    askForLayer(this, (event.target as HTMLSelectElement).value as Layer);
  }

  private get isComputing(): boolean {
    return needsExact(this.layer) && this.exact === 'computing';
  }

  /** The number of pixels that differ; null if another layer is shown, or it is not known yet. */
  private get difference(): Difference | null {
    const right = known(this.exact);
    if (this.layer !== 'difference' || right === null) return null;
    return differenceOf(this.view.screen.picture, right);
  }

  /** The meaning of the layer as plain text. */
  private words(): string {
    const { say, layer, difference } = this;
    if (this.isComputing) return say.computing;
    if (layer === 'depths') return say.fromTo(...this.ends());
    if (difference === null) return layer === 'exact' ? say.exactly : say.soFar;
    return `${say.wrong(difference.wrong)}, ${say.lacking(difference.lacking)}`;
  }

  private ends(): readonly [far: string, near: string] {
    const [far, near] = depthRange(this.view.header.scene);
    const { short } = numbersOf(this.view);
    return [short(far), short(near)];
  }

  /** The status of the layer; the picture so far needs none. */
  private status(): TemplateResult | typeof nothing {
    const { say, layer, difference } = this;
    if (layer === 'depths') {
      const [far, near] = this.ends();
      return html`<p class="status depths">
        <span class="number">${far}</span
        ><span class="ramp" role="img" aria-label=${say.ramp}></span
        ><span class="number">${near}</span>
      </p>`;
    }
    if (difference !== null) {
      return html`<p class="status difference">
        <span><i class="wrong"></i>${say.wrong(difference.wrong)}</span>
        <span><i class="lacking"></i>${say.lacking(difference.lacking)}</span>
      </p>`;
    }
    return layer === 'picture' ? nothing : html`<p class="status">${this.words()}</p>`;
  }
}
