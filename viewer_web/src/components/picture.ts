import { LitElement, html, nothing, svg } from 'lit';
import type { PropertyValues, SVGTemplateResult, TemplateResult } from 'lit';
import { customElement, property, query, state } from 'lit/decorators.js';
import { guard } from 'lit/directives/guard.js';
import { texts as allTexts } from '../i18n/index.js';
import type { Editing } from '../live/editor.js';
import { Frame } from '../picture/frame.js';
import { marksOf, target } from '../picture/marks.js';
import { paint } from '../picture/paint.js';
import { patchesOf } from '../picture/patches.js';
import { isIn, moved, nearestIn } from '../picture/pixel.js';
import type { Pixel } from '../picture/pixel.js';
import { drawn, shapesOf } from '../picture/shapes.js';
import { labelSize, labelsOf, stillShapes } from '../picture/still.js';
import type { View } from '../view.js';
import './handles.js';
import { hiddenStyle } from './hidden.style.js';
import { OwnSize } from './own-size.js';
import { marksStyle, pictureStyle } from './picture.style.js';
import { Printing } from './printing.js';
import { base } from './theme.js';

/** The picture so far, and over it what the step is about. A pixel of it may be chosen, by mouse or keyboard. */
@customElement('vidno-picture')
export class PictureElement extends LitElement {
  static override styles = [base, hiddenStyle, marksStyle, pictureStyle];

  @property({ attribute: false }) view!: View;
  /** The scene while its corners may be dragged. */
  @property({ attribute: false }) editing: Editing | null = null;
  /** Where the keyboard is about to choose, while it does. */
  @state() private cursor: Pixel | null = null;
  @query('svg') private stage!: SVGSVGElement;
  @query('canvas') private canvas!: HTMLCanvasElement;

  private left: Pixel | null = null;

  private readonly size = new OwnSize(this);
  private readonly printing = new Printing(this);

  private get frame(): Frame {
    return new Frame(this.view.header.scene.area, this.size.value);
  }

  /** Gives the keyboard to the choice of a pixel. */
  startChoosing(): void {
    this.stage.focus();
  }

  override updated(changed: PropertyValues<this>): void {
    super.updated(changed);
    this.paint();
  }

  private paint(): void {
    const ratio = window.devicePixelRatio * this.size.zoom;
    const { canvas } = this;
    const { width, height } = this.size.value;
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    paint(canvas, this.view.screen.picture, this.frame.place(ratio));
  }

  /** A press of the mouse must not take the focus: arrow keys would no longer be steps. */
  private readonly keepFocus = (event: Event): void => event.preventDefault();

  private onClick({ clientX, clientY }: MouseEvent): void {
    const { left, top } = this.getBoundingClientRect();
    const { zoom } = this.size;
    const pixel = this.frame.pixelAt((clientX - left) / zoom, (clientY - top) / zoom);
    if (isIn(pixel, this.view.header.scene.area)) this.choose(pixel);
  }

  private onFocus(): void {
    const { area } = this.view.header.scene;
    const { x, y, width, height } = area;
    const middle: Pixel = [x + (width >> 1), y + (height >> 1)];
    this.cursor = nearestIn(this.view.pixel ?? this.left ?? middle, area);
  }

  private onBlur(): void {
    this.left = this.cursor;
    this.cursor = null;
  }

  /** While the picture has the focus, arrow keys move the cursor. */
  private onKey(event: KeyboardEvent): void {
    const { cursor } = this;
    if (cursor === null || event.ctrlKey || event.metaKey || event.altKey) return;
    const next = moved(cursor, event.key, event.shiftKey, this.view.header.scene.area);
    if (next !== null) this.cursor = next;
    else if (event.key === 'Enter') this.choose(cursor);
    else if (event.key === 'Escape') this.stage.blur();
    else return;
    event.preventDefault();
  }

  private choose(pixel: Pixel): void {
    this.dispatchEvent(new CustomEvent<Pixel>('pixel', { detail: pixel }));
  }

  override render(): TemplateResult {
    const { header, texts, language } = this.view;
    const { history } = allTexts[language];
    const { shown, scale } = this.frame;
    return html`
      <canvas aria-hidden="true"></canvas>
      <svg
        viewBox=${shown.join(' ')}
        role="application"
        tabindex="0"
        aria-label="${texts.picture}: ${header.scene.name}"
        aria-describedby="how"
        @mousedown=${this.keepFocus}
        @click=${this.onClick}
        @focus=${this.onFocus}
        @blur=${this.onBlur}
        @keydown=${this.onKey}
      >
        ${this.printing.now ? this.pixels() : nothing}
        ${guard([header, scale, language], () => this.still())}
        ${marksOf(this.view).flatMap((mark) => shapesOf(mark, scale).map(drawn))}
        ${guard([header, scale], () => this.labels())}
        ${this.cursor === null ? nothing : shapesOf(target('cursor', this.cursor), scale).map(drawn)}
      </svg>
      ${
        this.editing === null
          ? nothing
          : html`<vidno-handles .editing=${this.editing} .language=${language}></vidno-handles>`
      }
      <p class="heard" id="how">${history.how}</p>
      <p class="heard" aria-live="polite">
        ${this.cursor === null ? '' : history.at(...this.cursor)}
      </p>
    `;
  }

  /** On paper the pixels are as sharp as the lines. */
  private pixels(): readonly SVGTemplateResult[] {
    const { screen, header } = this.view;
    return patchesOf(screen.picture, header.scene.area).map(
      ({ color, d }) => svg`<path class="pixels" .style=${`fill: ${color}`} d=${d} />`,
    );
  }

  /** What does not change from step to step. */
  private still(): readonly SVGTemplateResult[] {
    return stillShapes(this.view.header.scene, this.frame).map(drawn);
  }

  private labels(): readonly SVGTemplateResult[] {
    const size = labelSize / this.frame.scale;
    return labelsOf(this.view.header.scene, this.frame).map(
      ({ text, at: [x, y] }) =>
        svg`<text class="label" x=${x} y=${y} font-size=${size}>${text}</text>`,
    );
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'vidno-picture': PictureElement;
  }
}
