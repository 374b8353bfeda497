import { LitElement, css, html, svg } from 'lit';
import type { SVGTemplateResult, TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { base } from '../elements/theme.js';
import { whole } from '../language/words.js';
import type { Frame } from './frame.js';
import type { Pixel } from './pixel.js';

/** The distance of numbers on an axis: 1, 2, 5, 10, 20, 50 and so on, at least a given distance. */
export function stepOf(least: number): number {
  for (let ten = 1; ; ten *= 10) {
    const found = [1, 2, 5].find((n) => n * ten >= least);
    if (found !== undefined) return found * ten;
  }
}

/** The numbers on an axis in a range, at least a given distance apart. */
export function ticksIn(first: number, last: number, least: number): number[] {
  const step = stepOf(least);
  const start = Math.ceil(first / step) * step;
  const count = Math.max(0, Math.floor((last - start) / step) + 1);
  return Array.from({ length: count }, (_, i) => start + i * step);
}

/** CSS pixels: the distance of numbers from the area, their distance from the edge of the box, and the width of a digit. */
const off = 5;
const edge = 1;
const letter = 6.5;
/** The least distance between numbers, in CSS pixels. */
const apart = { x: 30, y: 17 };

/** What the numbers belong to: pixels, numbered at their centres, or the whole numbers themselves. */
export type Numbered = 'pixels' | 'lines';

/** The position of a number along an axis, in units of the plane. */
export const placeOf = (n: number, numbered: Numbered): number =>
  numbered === 'pixels' ? n + 0.5 : n;

/** The numbers of columns and rows along the area. Where its edge is out of sight, they are along the edge of the box. */
@customElement('vidno-axes')
export class AxesElement extends LitElement {
  static override styles = [
    base,
    css`
      :host {
        position: absolute;
        inset: 0;
        contain: strict;
        pointer-events: none;
      }
      svg {
        display: block;
        width: var(--across, 100%);
        height: var(--down, 100%);
      }
      text {
        fill: var(--soft);
        stroke: var(--well);
        stroke-width: 3px;
        paint-order: stroke;
        font: 0.6875rem var(--mono);
        font-size: 11px;
      }
      .column {
        text-anchor: middle;
      }
      .row {
        text-anchor: end;
        dominant-baseline: central;
      }
      .pointed {
        fill: var(--ink);
        font-weight: 700;
      }
      @media (forced-colors: active) {
        text {
          fill: var(--forced-ink, CanvasText);
          stroke: var(--forced-paper, Canvas);
        }
      }
    `,
  ];

  @property({ attribute: false }) frame!: Frame;
  /** The pixel under the pointer, whose column and row are always numbered. */
  @property({ attribute: false }) pointed: Pixel | null = null;

  @property({ attribute: false }) numbered: Numbered = 'pixels';

  override render(): TemplateResult {
    const { frame } = this;
    const { width, height } = frame.size;
    return html`<svg viewBox="0 0 ${width} ${height}" aria-hidden="true">
      ${this.numbers('x').map(([n, at]) => this.column(n, at))}
      ${this.numbers('y').map(([n, at]) => this.row(n, at))}
    </svg>`;
  }

  /** The numbers along an axis and their positions. No other number is close to the pointed one. */
  private numbers(axis: 'x' | 'y'): readonly (readonly [n: number, at: number])[] {
    const { area, shown, scale } = this.frame;
    const [from, length] = axis === 'x' ? [area.x, area.width] : [area.y, area.height];
    const [start, seen] = axis === 'x' ? [shown[0], shown[2]] : [shown[1], shown[3]];
    const first = Math.max(from, Math.floor(start));
    const last = Math.min(from + length, Math.ceil(start + seen)) - 1;
    const digits = String(last).length;
    const least = axis === 'x' ? Math.max(apart.x, (digits + 2) * letter) : apart.y;
    const at = (n: number): number => (placeOf(n, this.numbered) - start) * scale;
    const pointed = this.pointed?.[axis === 'x' ? 0 : 1] ?? null;
    const ticks = ticksIn(first, last, least / scale).filter(
      (n) => pointed === null || n === pointed || Math.abs(at(n) - at(pointed)) >= least,
    );
    if (pointed !== null && !ticks.includes(pointed) && pointed >= first && pointed <= last) {
      ticks.push(pointed);
    }
    return ticks.map((n) => [n, at(n)]);
  }

  private column(n: number, x: number): SVGTemplateResult {
    const { area, shown, scale, size } = this.frame;
    const top = (area.y - shown[1]) * scale - off;
    const y = Math.min(Math.max(top, edge + 12), size.height - 3);
    return svg`<text class="column ${this.kind(0, n)}" x=${x} y=${y}>${whole(n)}</text>`;
  }

  private row(n: number, y: number): SVGTemplateResult {
    const { area, shown, scale } = this.frame;
    const left = (area.x - shown[0]) * scale - off;
    const x = Math.max(left, edge + String(n).length * letter);
    return svg`<text class="row ${this.kind(1, n)}" x=${x} y=${y}>${whole(n)}</text>`;
  }

  private kind(axis: 0 | 1, n: number): string {
    return this.pointed?.[axis] === n ? 'pointed' : '';
  }
}
