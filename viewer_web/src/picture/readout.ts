import { LitElement, css, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { numbersOf } from '../algorithm/view.js';
import type { View } from '../algorithm/view.js';
import { swatch } from '../elements/parts.js';
import { base } from '../elements/theme.js';
import { texts } from '../i18n/index.js';
import { approximately } from '../language/words.js';
import { factsIn } from './pixel-facts.js';
import type { PixelFacts } from './pixel-facts.js';
import { isIn } from './pixel.js';
import type { Pixel } from './pixel.js';

/** The facts about the pixel under the pointer: its position, its polygon, its depth and its colour. */
@customElement('vidno-readout')
export class ReadoutElement extends LitElement {
  static override styles = [
    base,
    css`
      :host {
        display: flex;
        gap: 0.7rem;
        align-items: center;
        min-width: 0;
        overflow: hidden;
        color: var(--soft);
        font: 0.75rem var(--mono);
        white-space: nowrap;
      }
      span {
        flex: none;
      }
      .pixel {
        color: var(--ink);
      }
      .owner {
        flex: 0 1 auto;
        min-width: 2.5em;
        overflow: hidden;
        text-overflow: ellipsis;
      }
      .swatch {
        margin-right: 0.3em;
      }
    `,
  ];

  @property({ attribute: false }) view!: View;
  /** The pixel under the pointer; without one the readout gives the size of the picture. */
  @property({ attribute: false }) at: Pixel | null = null;

  override render(): TemplateResult {
    const { view, at } = this;
    const { area, curves } = view.header.scene;
    if (at === null || !isIn(at, area)) return html`<span>${area.width} × ${area.height}</span>`;
    const place = html`<span class="pixel">${numbersOf(view).point(at)}</span>`;
    if (curves !== null) return place;
    const facts = factsIn(view, at);
    return html`${place} ${this.owner(facts)} ${this.depth(facts)}
    ${facts.color === null ? nothing : html`<span>${facts.color}</span>`}`;
  }

  /** The polygon, or all that it may be if the trace does not say which. */
  private owner({ color, owners: { polygons, background } }: PixelFacts): TemplateResult {
    const { readout } = texts[this.view.language].picture;
    if (color === null) return html`<span>${readout.unpainted}</span>`;
    const all = [...polygons, ...(background ? [readout.background] : [])];
    const names = all.join(readout.or);
    return html`<span class="owner" title=${names}>${swatch(color)}${names}</span>`;
  }

  private depth({ depth, isStored }: PixelFacts): TemplateResult | typeof nothing {
    if (depth === null) return nothing;
    const z = numbersOf(this.view).short(depth);
    return html`<span>${equals(isStored ? z : approximately(z))}</span>`;
  }
}

/** An equals sign, unless the number has the mark of a shortened number. */
const equals = (z: string): string =>
  z.startsWith('≈') ? `z ≈ ${z.replace(/^≈+/u, '')}` : `z = ${z}`;
