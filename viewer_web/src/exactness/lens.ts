import { LitElement, css, html } from 'lit';
import type { PropertyValues, TemplateResult } from 'lit';
import { customElement, property, query, state } from 'lit/decorators.js';
import { base } from '../elements/theme.js';
import type { ExactTexts } from '../language/texts.js';
import { moves } from '../picture/pixel.js';
import { middle, side } from './places.js';
import type { SignMap } from './sign-map.js';

/** Canvas pixels per place. */
const zoom = 8;

/**
 * The colours by computed sign, for right and wrong places. They are those of `vidno map`, and remain distinguishable in
 * grey.
 */
const pale = ['#ffe2cc', '#ffffff', '#a5c8f0'] as const;
const dark = ['#d75f00', '#000000', '#1e46aa'] as const;
const signs = [-1, 0, 1] as const;

type Place = readonly [i: number, j: number];

/** A sign map, with the point in its middle and y downward as in the picture. An arrow key or the mouse selects a place. */
@customElement('vidno-lens')
export class LensElement extends LitElement {
  static override styles = [
    base,
    css`
      canvas {
        display: block;
        width: 100%;
        aspect-ratio: 1;
        border: 1px solid var(--line);
        cursor: crosshair;
      }
      p {
        min-height: 1.45em;
        margin-top: 0.3rem;
        font-size: 0.8125rem;
        overflow-wrap: anywhere;
      }
      ul {
        display: flex;
        flex-wrap: wrap;
        gap: 0.2rem 0.9rem;
        padding: 0;
        list-style: none;
        color: var(--soft);
        font-size: 0.75rem;
      }
      i {
        display: inline-block;
        width: 0.8rem;
        height: 0.8rem;
        margin-right: 0.15rem;
        border: 1px solid var(--line);
        vertical-align: -0.1rem;
      }
    `,
  ];

  @property({ attribute: false }) map!: SignMap;
  @property({ attribute: false }) texts!: ExactTexts;
  /** Whether the decision is one of yes or no. */
  @property({ type: Boolean }) plain = false;
  @property() label = '';
  @state() private place: Place = [middle, middle];
  @query('canvas') private canvas!: HTMLCanvasElement;

  override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has('map')) this.place = [middle, middle];
  }

  override updated(): void {
    const context = this.canvas.getContext('2d');
    if (context !== null) this.paint(context);
  }

  private paint(context: CanvasRenderingContext2D): void {
    for (let j = 0; j < side; j++) {
      for (let i = 0; i < side; i++) {
        const { computed, exact } = this.map.at(i, j);
        context.fillStyle = (computed === exact ? pale : dark)[computed + 1] ?? '';
        context.fillRect(i * zoom, j * zoom, zoom, zoom);
      }
    }
    this.border(context);
    this.frame(context, [middle, middle], 3);
    this.frame(context, this.place, 1);
  }

  /** The border where the exact sign changes, black beside white so that it is visible on pale and dark colours. */
  private border(context: CanvasRenderingContext2D): void {
    const line = (color: string, x: number, y: number, width: number, height: number): void => {
      context.fillStyle = color;
      context.fillRect(x, y, width, height);
    };
    for (let j = 0; j < side; j++) {
      for (let i = 0; i < side; i++) {
        const here = this.map.at(i, j).exact;
        const x = i * zoom;
        const y = j * zoom;
        const shade = (beyond: number): readonly [string, string] =>
          here < beyond ? ['#000000', '#ffffff'] : ['#ffffff', '#000000'];
        if (i + 1 < side && this.map.at(i + 1, j).exact !== here) {
          const [near, far] = shade(this.map.at(i + 1, j).exact);
          line(near, x + zoom - 1, y, 1, zoom);
          line(far, x + zoom, y, 1, zoom);
        }
        if (j + 1 < side && this.map.at(i, j + 1).exact !== here) {
          const [near, far] = shade(this.map.at(i, j + 1).exact);
          line(near, x, y + zoom - 1, zoom, 1);
          line(far, x, y + zoom, zoom, 1);
        }
      }
    }
  }

  /** A ring around a place. */
  private frame(context: CanvasRenderingContext2D, [i, j]: Place, out: number): void {
    const at = [i * zoom - out, j * zoom - out] as const;
    const size = zoom + 2 * out;
    context.lineWidth = 3;
    context.strokeStyle = '#ffffff';
    context.strokeRect(...at, size, size);
    context.lineWidth = 1.5;
    context.strokeStyle = '#000000';
    context.strokeRect(...at, size, size);
  }

  override render(): TemplateResult {
    const { texts } = this;
    const names = this.plain ? texts.yesNo : texts.signs;
    const shown = this.plain ? ([-1, 1] as const) : signs;
    return html`
      <canvas
        width=${side * zoom}
        height=${side * zoom}
        tabindex="0"
        role="application"
        aria-label="${this.label}. ${this.read()}"
        @pointermove=${this.onPointer}
        @pointerdown=${this.onPointer}
        @pointerleave=${() => (this.place = [middle, middle])}
        @keydown=${this.onKey}
      ></canvas>
      <p aria-live="polite">${this.read()}</p>
      <ul>
        ${shown.map(
          (sign) =>
            html`<li>
              <i .style=${`background: ${pale[sign + 1] ?? ''}`}></i
              ><i .style=${`background: ${dark[sign + 1] ?? ''}`}></i> ${names[sign]}
            </li>`,
        )}
        <li>${texts.pale}; ${texts.dark}</li>
      </ul>
    `;
  }

  /** The text about the selected place. */
  private read(): string {
    const [i, j] = this.place;
    const { computed, exact } = this.map.at(i, j);
    const names = this.plain ? this.texts.yesNo : this.texts.signs;
    return this.texts.cell(i - middle, j - middle, names[computed], names[exact]);
  }

  private onPointer(event: PointerEvent): void {
    const { width, height } = this.canvas.getBoundingClientRect();
    const inside = (at: number): number => Math.min(side - 1, Math.max(0, Math.floor(at)));
    this.place = [inside((event.offsetX / width) * side), inside((event.offsetY / height) * side)];
  }

  private onKey(event: KeyboardEvent): void {
    const move = moves[event.key];
    if (move === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    const [i, j] = this.place;
    const inside = (at: number): number => Math.min(side - 1, Math.max(0, at));
    this.place = [inside(i + move[0]), inside(j + move[1])];
  }
}
