import { LitElement, html, nothing, svg } from 'lit';
import type { PropertyValues, SVGTemplateResult, TemplateResult } from 'lit';
import { customElement, property, query, state } from 'lit/decorators.js';
import { guard } from 'lit/directives/guard.js';
import { texts as allTexts } from '../i18n/index.js';
import type { Editing } from '../live/editor.js';
import { Frame } from '../picture/frame.js';
import type { Point, Zoom, Zooming } from '../picture/frame.js';
import { cellsOf } from '../picture/layers.js';
import type { Exact, Layer } from '../picture/layers.js';
import { target } from '../picture/mark.js';
import { marksOf } from '../picture/marks.js';
import { paint } from '../picture/paint.js';
import { patchesOf } from '../picture/patches.js';
import { isIn, moved, nearestIn } from '../picture/pixel.js';
import type { Pixel } from '../picture/pixel.js';
import { shapesOf } from '../picture/shapes.js';
import { gridShapes, labelsOf, notesOf, outlineShapes, shapesToPoint } from '../picture/still.js';
import type { Area } from '../trace/header.js';
import type { View } from '../view.js';
import { drawn, labels } from './drawn.js';
import { Gestures } from './gestures.js';
import './handles.js';
import { hiddenStyle } from './hidden.style.js';
import { Keyboard } from './keyboard.js';
import type { Actions } from './keyboard.js';
import { marksStyle } from './marks.style.js';
import { OwnSize, pointIn } from './own-size.js';
import { pictureStyle } from './picture.style.js';
import { Printing } from './printing.js';
import { base } from './theme.js';
import './zoom-bar.js';

/** How much larger a key or a button makes the picture. */
const zoomStep = 1.5;

/**
 * The picture so far, and over it what the step is about. A pixel of it may be chosen, by mouse or keyboard, and what
 * is shown of it may be enlarged and moved.
 */
@customElement('vidno-picture')
export class PictureElement extends LitElement {
  static override styles = [base, hiddenStyle, marksStyle, pictureStyle];

  @property({ attribute: false }) view!: View;
  /** What the pixels show. */
  @property({ attribute: false }) layer: Layer = 'picture';
  @property({ attribute: false }) exact: Exact = null;
  /** The scene while its corners may be dragged. */
  @property({ attribute: false }) editing: Editing | null = null;
  /** Where the keyboard is about to choose, while it does. */
  @state() private cursor: Pixel | null = null;
  @query('svg') private stage!: SVGSVGElement;
  @query('canvas') private canvas!: HTMLCanvasElement;

  /** The part of the picture that is shown. */
  @state() private zoom: Zoom | null = null;

  private left: Pixel | null = null;

  private readonly size = new OwnSize(this);
  private readonly gestures = new Gestures(
    () => this.frame,
    (frame) => (this.zoom = frame.zoom),
  );
  private known: Frame | null = null;
  private readonly printing = new Printing(this);

  /** The same one as long as nothing about it changes. */
  private get frame(): Frame {
    const { size, zoom, known } = this;
    const { area } = this.view.header.scene;
    const isSame = known?.area === area && known.size === size.value && known.wanted === zoom;
    if (isSame) return known;
    return (this.known = new Frame(area, size.value, zoom));
  }

  /** Gives the keyboard to the choice of a pixel. */
  startChoosing(): void {
    this.stage.focus();
  }

  constructor() {
    super();
    new Keyboard(this, () => this.zoomKeys());
    this.addEventListener('wheel', this.gestures.onWheel, { passive: false });
  }

  override willUpdate(changed: PropertyValues<this>): void {
    const before = changed.get('view')?.header.scene.area;
    if (before && isOtherArea(before, this.view.header.scene.area)) this.zoom = null;
  }

  override updated(changed: PropertyValues<this>): void {
    super.updated(changed);
    this.paint();
  }

  private paint(): void {
    const ratio = window.devicePixelRatio * this.size.zoom;
    const { canvas, frame } = this;
    const { width, height } = frame.size;
    canvas.width = Math.ceil(width * ratio);
    canvas.height = Math.ceil(height * ratio);
    // A dot of the canvas is one of the device.
    canvas.style.width = `${canvas.width / ratio}px`;
    canvas.style.height = `${canvas.height / ratio}px`;
    paint(canvas, cellsOf(this.layer, this.view.screen, this.exact), frame.place(ratio));
  }

  private zoomTo(way: Zooming): void {
    const { frame } = this;
    if (way === 'whole') this.zoom = null;
    else this.zoom = frame.zoomed(way === 'in' ? zoomStep : 1 / zoomStep).zoom;
  }

  private zoomKeys(): Actions {
    return {
      '+': () => this.zoomTo('in'),
      '=': () => this.zoomTo('in'),
      '-': () => this.zoomTo('out'),
      '0': () => this.zoomTo('whole'),
    };
  }

  /** What the keyboard is at must be seen: a pixel, or a point. */
  private follow(at: Point, side: number): void {
    this.zoom = this.frame.showing(at, side).zoom;
  }

  /** A press of the mouse must not take the focus: arrow keys would no longer be steps. */
  private readonly keepFocus = (event: Event): void => event.preventDefault();

  private onClick(event: MouseEvent): void {
    if (this.gestures.dragged) return;
    const pixel = this.frame.pixelAt(...pointIn(this, event));
    if (isIn(pixel, this.view.header.scene.area)) this.choose(pixel);
  }

  private onFocus(): void {
    const { area } = this.view.header.scene;
    const { width, height } = this.frame.size;
    const middle = this.frame.pixelAt(width / 2, height / 2);
    this.moveCursor(nearestIn(this.view.pixel ?? this.left ?? middle, area));
  }

  private moveCursor(to: Pixel): void {
    this.cursor = to;
    this.follow(to, 1);
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
    if (next !== null) this.moveCursor(next);
    else if (event.key === 'Enter') this.choose(cursor);
    else if (event.key === 'Escape') this.stage.blur();
    else return;
    event.preventDefault();
  }

  private choose(pixel: Pixel): void {
    this.dispatchEvent(new CustomEvent<Pixel>('pixel', { detail: pixel }));
  }

  override render(): TemplateResult {
    const { frame, gestures } = this;
    const { header, texts, language } = this.view;
    const { history, picture } = allTexts[language];
    const { shown, scale } = frame;
    const marks = marksOf(this.view, frame.sight);
    return html`
      <canvas aria-hidden="true"></canvas>
      <svg
        viewBox=${shown.join(' ')}
        class=${frame.zoom === null ? nothing : 'zoomed'}
        role="application"
        tabindex="0"
        aria-label="${texts.picture}: ${header.scene.name}"
        aria-describedby="how"
        @mousedown=${this.keepFocus}
        @click=${this.onClick}
        @focus=${this.onFocus}
        @blur=${this.onBlur}
        @keydown=${this.onKey}
        @pointerdown=${gestures.onDown}
        @pointermove=${gestures.onMove}
        @pointerup=${gestures.onEnd}
        @pointercancel=${gestures.onEnd}
        @touchmove=${{ handleEvent: gestures.onTouch, passive: false }}
      >
        ${this.printing.now ? this.pixels() : nothing}
        ${guard([frame], () => gridShapes(frame).map(drawn))}
        ${guard([header], () => this.outlines())}
        ${marks.flatMap((mark) => shapesOf(mark, scale).map(drawn))}
        ${guard([header, scale], () => labels(labelsOf(header.scene, frame), frame, true))}
        ${labels(notesOf(marks, frame), frame)}
        ${this.cursor === null ? nothing : shapesOf(target('cursor', this.cursor), scale).map(drawn)}
      </svg>
      ${
        this.editing === null
          ? nothing
          : html`<vidno-handles
              .editing=${this.editing}
              .frame=${frame}
              .language=${language}
              @follow=${({ detail }: CustomEvent<Point>) => this.follow(detail, 0)}
            ></vidno-handles>`
      }
      <vidno-zoom-bar
        .frame=${frame}
        .texts=${picture}
        @zoom=${({ detail }: CustomEvent<Zooming>) => this.zoomTo(detail)}
      ></vidno-zoom-bar>
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

  private outlines(): readonly SVGTemplateResult[] {
    const { scene } = this.view.header;
    return [...outlineShapes(scene), ...shapesToPoint(scene)].map(drawn);
  }
}

const isOtherArea = (a: Area, b: Area): boolean =>
  a.x !== b.x || a.y !== b.y || a.width !== b.width || a.height !== b.height;

declare global {
  interface HTMLElementTagNameMap {
    'vidno-picture': PictureElement;
  }
}
