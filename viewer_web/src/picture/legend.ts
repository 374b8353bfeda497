import { LitElement, css, html, nothing, svg } from 'lit';
import type { SVGTemplateResult, TemplateResult } from 'lit';
import { customElement, property, state } from 'lit/decorators.js';
import { showsOf } from '../algorithm/shows.js';
import type { View } from '../algorithm/view.js';
import { base } from '../elements/theme.js';
import { texts } from '../i18n/index.js';
import type { LegendEntry } from '../language/texts.js';
import { curvesStyle } from './curves.style.js';
import { marksStyle } from './marks.style.js';
import { regionsStyle } from './regions.style.js';

const dots: readonly LegendEntry[] = ['yes', 'no', 'edge'];

/** The meaning of the marks on the picture. Its slot has the controls of the picture. */
@customElement('vidno-legend')
export class LegendElement extends LitElement {
  static override styles = [
    base,
    marksStyle,
    curvesStyle,
    regionsStyle,
    css`
      :host {
        position: relative;
        display: flex;
        gap: 0.25rem;
      }
      button {
        min-height: 1.5rem;
        padding: 0 0.4rem;
        color: var(--soft);
        font-size: 0.75rem;
      }
      button[aria-expanded='true'] {
        border-color: var(--accent);
        color: var(--accent);
      }
      ul {
        position: absolute;
        right: 0;
        bottom: calc(100% + 0.5rem);
        z-index: 2;
        display: grid;
        grid-template-columns: auto auto;
        gap: 0.2rem 1.2rem;
        padding: 0.6rem 0.8rem;
        border: 1px solid var(--line);
        border-radius: var(--radius);
        background: var(--panel);
        box-shadow: 0 4px 20px rgb(10 12 18 / 30%);
        list-style: none;
        font-size: 0.8125rem;
      }
      li {
        display: flex;
        gap: 0.35rem;
        align-items: center;
        white-space: nowrap;
      }
      svg {
        width: 1.25rem;
        height: 0.875rem;
        background: #ffffff;
        border-radius: 2px;
      }
    `,
  ];

  @property({ attribute: false }) view!: View;
  @state() private isOpen = false;

  override render(): TemplateResult {
    return html`<button
        aria-expanded=${this.isOpen ? 'true' : 'false'}
        @click=${() => (this.isOpen = !this.isOpen)}
        @keydown=${this.onKey}
      >
        ${texts[this.view.language].picture.legend}
      </button>
      <slot></slot>
      ${this.isOpen ? this.entries() : nothing}`;
  }

  private onKey(event: KeyboardEvent): void {
    if (event.key !== 'Escape' || !this.isOpen) return;
    this.isOpen = false;
    event.preventDefault();
  }

  private entries(): TemplateResult {
    const { texts: page } = this.view;
    const { legend, icon } = showsOf(this.view);
    return html`<ul>
      ${legend.map(
        (entry) =>
          html`<li>
            <svg viewBox="0 0 20 14" aria-hidden="true">${icon?.(entry) ?? plainIcon(entry)}</svg
            >${page.legend[entry]}
          </li>`,
      )}
    </ul>`;
  }
}

function plainIcon(entry: LegendEntry): SVGTemplateResult {
  if (entry === 'chosen') {
    return svg`<path class="chosen" d="M6 3.5h8v7h-8ZM10 1v2.5M10 10.5v2.5M3 7h3M14 7h3" />`;
  }
  if (dots.includes(entry)) return svg`<circle class="dot ${entry}" cx="10" cy="7" r="4.5" />`;
  if (entry === 'tree') {
    return svg`<path class="tree" d="M2.5 1.5h15v11h-15ZM10 1.5v11M2.5 7h15M6.25 7v5.5M2.5 9.75h7.5" />`;
  }
  if (entry !== 'active') return svg`<rect class=${entry} x="3" y="3" width="14" height="8" />`;
  return svg`<path class="casing active" d="M3 11L17 3" />
    <path class="active" d="M3 11L17 3" stroke="#d08a00" />`;
}
