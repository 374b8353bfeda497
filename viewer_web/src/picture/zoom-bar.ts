import { LitElement, css, html, nothing, svg } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { base } from '../elements/theme.js';
import type { PictureTexts } from '../language/texts.js';
import type { Frame, Zooming } from './frame.js';

/** Lines in a square of 20. */
const shapes: Readonly<Record<Zooming, string>> = {
  out: 'M4 10H16',
  in: 'M4 10H16M10 4V16',
  whole: 'M3 7.5V3H7.5M12.5 3H17V7.5M17 12.5V17H12.5M7.5 17H3V12.5',
  all: 'M7 7H13V13H7ZM3 6V3H6M14 3H17V6M17 14V17H14M6 17H3V14',
};

/** Buttons that zoom the picture. An event `zoom` carries the command. */
@customElement('vidno-zoom-bar')
export class ZoomBarElement extends LitElement {
  static override styles = [
    base,
    css`
      :host {
        display: var(--tools, block);
        visibility: var(--quiet, visible);
        position: absolute;
        /* The numbers of the axes are at the other sides. */
        bottom: 0.375rem;
        right: 0.375rem;
      }
      /* Here the picture fills its width, and the bar hides numbers instead of pixels. */
      @container (max-width: 520px) {
        :host {
          inset: 0 0 auto auto;
        }
        [aria-disabled='true']:not(:focus) {
          display: none;
        }
      }
      div {
        display: flex;
        border: 1px solid var(--line);
        border-radius: 6px;
        overflow: hidden;
        background: var(--panel);
      }
      .upright {
        flex-direction: column;
      }
      button {
        display: grid;
        place-items: center;
        width: 1.75rem;
        min-height: 1.75rem;
        padding: 0;
        border: 0;
        border-radius: 0;
      }
      button + button {
        border-left: 1px solid var(--line);
      }
      .upright button + button {
        border-top: 1px solid var(--line);
        border-left: 0;
      }
      button:hover:not([aria-disabled='true']) {
        background: var(--accent-wash);
      }
      button[aria-disabled='true'] {
        cursor: default;
      }
      [aria-disabled='true'] svg {
        opacity: 0.4;
      }
      :focus-visible {
        outline-offset: -3px;
      }
      svg {
        width: 1rem;
        height: 1rem;
        fill: none;
        stroke: currentColor;
        stroke-width: 2;
      }
    `,
  ];

  @property({ attribute: false }) frame!: Frame;
  @property({ attribute: false }) texts!: PictureTexts;

  override render(): TemplateResult {
    const { texts, frame } = this;
    const isWhole = frame.zoom === null;
    const { size, area } = frame;
    // There is more room beside the picture than below it.
    const isUpright = size.width * area.height > size.height * area.width;
    return html`<div role="group" class=${isUpright ? 'upright' : ''} aria-label=${texts.zoom}>
      ${this.button('out', frame.isSmallest)} ${this.button('in', frame.isLargest)}
      ${this.button('whole', isWhole)}
      ${frame.hasMore ? this.button('all', frame.isSmallest) : nothing}
    </div>`;
  }

  private button(way: Zooming, off: boolean): TemplateResult {
    const label = this.texts[way];
    return html`<button
      aria-label=${label}
      title=${label}
      aria-disabled=${off ? 'true' : 'false'}
      @click=${() => this.dispatchEvent(new CustomEvent<Zooming>('zoom', { detail: way }))}
    >
      <svg viewBox="0 0 20 20" aria-hidden="true">${svg`<path d=${shapes[way]} />`}</svg>
    </button>`;
  }
}
