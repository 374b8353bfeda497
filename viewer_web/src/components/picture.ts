import { LitElement, html, nothing, svg } from 'lit';
import type { PropertyValues, SVGTemplateResult, TemplateResult } from 'lit';
import { customElement, property, query, state } from 'lit/decorators.js';
import { guard } from 'lit/directives/guard.js';
import { texts as allTexts } from '../i18n/index.js';
import type { Editing } from '../live/editor.js';
import { Frame } from '../picture/frame.js';
import { marksOf, target } from '../picture/marks.js';
import { paint } from '../picture/paint.js';
import { isIn, moved, nearestIn } from '../picture/pixel.js';
import type { Pixel } from '../picture/pixel.js';
import { outline, outlineToPoint, shapeOf } from '../picture/shapes.js';
import { polygonThing } from '../pointed.js';
import type { Polygon } from '../trace/header.js';
import type { View } from '../view.js';
import './handles.js';
import { hiddenStyle } from './hidden.style.js';
import { OwnSize } from './own-size.js';
import { marksStyle, pictureStyle } from './picture.style.js';
import { base } from './theme.js';

const mostLabels = 26;
const mostOutlines = 3000;
const many = 40;
const gridFrom = 7;

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
    const ratio = window.devicePixelRatio;
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
    const pixel = this.frame.pixelAt(clientX - left, clientY - top);
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
        ${guard([header, scale, language], () => this.still())}
        ${marksOf(this.view).map((mark) => shapeOf(mark, scale))}
        ${guard([header, scale], () => this.labels())}
        ${this.cursor === null ? nothing : shapeOf(target('cursor', this.cursor), scale)}
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

  /** What does not change from step to step. */
  private still(): SVGTemplateResult {
    const { area, polygons } = this.view.header.scene;
    const { x, y, width, height } = area;
    return svg`
      ${this.frame.scale >= gridFrom ? this.grid() : nothing}
      <rect class="area" x=${x} y=${y} width=${width} height=${height} />
      <g class=${polygons.length > many ? 'many' : nothing}>
        ${polygons.slice(0, mostOutlines).map((polygon) => outline(polygon))}
      </g>
      ${polygons.length > many ? nothing : polygons.map((polygon) => outlineToPoint(polygon))}
    `;
  }

  private grid(): SVGTemplateResult {
    const { x, y, width, height } = this.view.header.scene.area;
    const columns = Array.from({ length: width + 1 }, (_, i) => `M${x + i} ${y}v${height}`);
    const rows = Array.from({ length: height + 1 }, (_, j) => `M${x} ${y + j}h${width}`);
    return svg`<path class="grid" d=${[...columns, ...rows].join('')} />`;
  }

  private labels(): readonly SVGTemplateResult[] {
    const { polygons } = this.view.header.scene;
    return polygons.length > mostLabels ? [] : polygons.map((polygon) => this.label(polygon));
  }

  private label({ id, vertices }: Polygon): SVGTemplateResult {
    const [x, y] = labelSpot(vertices, this.frame.shown);
    return svg`<text class="label" data-thing=${polygonThing(id)} x=${x} y=${y} font-size=${13 / this.frame.scale}>${id}</text>`;
  }
}

/** A little inward from the first vertex: the middles of polygons often coincide. */
function labelSpot(
  vertices: Polygon['vertices'],
  [x, y, width, height]: readonly [number, number, number, number],
): readonly [number, number] {
  const within = (value: number, from: number, size: number): number =>
    Math.min(Math.max(value, from + size * 0.1), from + size * 0.9);
  const spot = (axis: 0 | 1): number => {
    const along = vertices.map((vertex) => vertex[axis]);
    const middle = along.reduce((sum, each) => sum + each, 0) / along.length;
    return (along[0] ?? 0) * 0.8 + middle * 0.2;
  };
  return [within(spot(0), x, width), within(spot(1), y, height)];
}

declare global {
  interface HTMLElementTagNameMap {
    'vidno-picture': PictureElement;
  }
}
