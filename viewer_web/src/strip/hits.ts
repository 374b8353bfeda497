import { LitElement, css, html } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property, query } from 'lit/decorators.js';
import { base } from '../elements/theme.js';
import { OwnDots } from '../picture/own-dots.js';
import { placeOf } from '../time/columns.js';
import { indexFrom } from '../time/goals.js';
import { wholeOf } from '../time/range.js';
import type { Range } from '../time/range.js';
import { marksHeight } from './lanes.js';
import { hitMark } from './paint.js';

/**
 * The steps that a search has found, as lines over a strip. They have a canvas of their own, because the strip takes longer
 * to paint.
 */
@customElement('vidno-hits')
export class HitsElement extends LitElement {
  static override styles = [
    base,
    css`
      :host {
        position: absolute;
        inset: 0 0 auto;
        height: ${marksHeight - 2}px;
        pointer-events: none;
      }
      canvas {
        display: block;
        width: 100%;
        height: 100%;
      }
    `,
  ];

  /** In rising order. */
  @property({ attribute: false }) hits: readonly number[] = [];
  @property({ attribute: false }) range: Range = wholeOf(0);
  @query('canvas') private canvas!: HTMLCanvasElement;

  private readonly dots = new OwnDots(this, () => this.canvas);

  override updated(): void {
    const { canvas, hits, range } = this;
    const { width, height } = this.dots.value;
    canvas.width = width;
    canvas.height = height;
    const context = canvas.getContext('2d');
    if (context === null || hits.length === 0 || width < 1) return;
    const ratio = height / (marksHeight - 2);
    const hit = getComputedStyle(this).getPropertyValue('--accent').trim();
    const end = indexFrom(hits, range.to + 1);
    let last = -1;
    for (let i = indexFrom(hits, range.from); i < end; i++) {
      const x = Math.min(width - 1, Math.floor(placeOf(hits[i] ?? 0, range, width)));
      if (x !== last) hitMark(context, x, 0, height, { ratio, hit });
      last = x;
    }
  }

  override render(): TemplateResult {
    return html`<canvas aria-hidden="true"></canvas>`;
  }
}
