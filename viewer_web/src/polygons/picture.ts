import { html, nothing, svg } from 'lit';
import type { PropertyValues, SVGTemplateResult } from 'lit';
import { customElement, property, query } from 'lit/decorators.js';
import { guard } from 'lit/directives/guard.js';
import { texts } from '../i18n/index.js';
import type { HistoryTexts } from '../language/texts.js';
import type { Editing } from '../editor/editor.js';
import { beyond } from '../picture/beyond.js';
import type { Frame, Point } from '../picture/frame.js';
import { cellsOf } from '../picture/layers.js';
import type { Exact, Layer } from '../picture/layers.js';
import { target } from '../picture/mark.js';
import { marksOf } from '../picture/marks.js';
import { paint } from '../picture/paint.js';
import type { Cells } from '../picture/paint.js';
import { patchesOf } from '../picture/patches.js';
import { factsAt } from '../picture/pixel-facts.js';
import type { Pixel } from '../picture/pixel.js';
import { shapesOf } from '../picture/shapes.js';
import { gridShapes, labelsOf, notesOf, outlineShapes, shapesToPoint } from '../picture/still.js';
import { drawn, labels } from '../picture/drawn.js';
import './handles.js';
import { numbersOf } from '../algorithm/view.js';
import { hiddenStyle } from '../elements/hidden.style.js';
import { marksStyle } from '../picture/marks.style.js';
import { pictureStyle } from '../picture/picture.style.js';
import { PlaneElement } from '../picture/plane.js';
import { Printing } from '../elements/printing.js';
import { base } from '../elements/theme.js';

/** The picture so far, and over it what the step is about. */
@customElement('vidno-picture')
export class PictureElement extends PlaneElement {
  static override styles = [base, hiddenStyle, marksStyle, pictureStyle];

  /** What the pixels show. */
  @property({ attribute: false }) layer: Layer = 'picture';
  @property({ attribute: false }) exact: Exact = null;
  /** The scene while its corners may be dragged. */
  @property({ attribute: false }) editing: Editing | null = null;
  @query('canvas') private canvas!: HTMLCanvasElement;

  private readonly printing = new Printing(this);

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
    paint(canvas, this.cells, frame.place(ratio));
  }

  /** What the pixels show; null if nothing. */
  protected get cells(): Cells | null {
    return cellsOf(this.layer, this.view.screen, this.exact);
  }

  /** What lies over the pixels and under the polygons' outlines, and what over these and under the marks. */
  protected under?(frame: Frame): unknown;
  protected over?(frame: Frame): unknown;

  protected override get words(): HistoryTexts {
    return texts[this.view.language].history;
  }

  protected override spoken(at: Pixel): string {
    return this.words.spoken(at, factsAt(this.view.screen, at));
  }

  protected override below(): unknown {
    return html`<canvas aria-hidden="true"></canvas>`;
  }

  protected override drawing(frame: Frame): unknown {
    const { header } = this.view;
    const { scale } = frame;
    const marks = marksOf(this.view, frame.sight);
    const outside = beyond(marks, frame, numbersOf(this.view));
    return svg`${this.printing.now && this.cells !== null ? this.pixels() : nothing}
      ${this.under?.(frame)}
      ${guard([frame], () => gridShapes(frame).map(drawn))}
      ${guard([header], () => this.outlines())}
      ${this.over?.(frame)}
      ${marks.flatMap((mark) => shapesOf(mark, scale).map(drawn))}
      ${guard([header, scale], () => labels(labelsOf(header.scene, frame), frame))}
      ${outside.shapes.map(drawn)} ${labels([...notesOf(marks, frame), ...outside.labels], frame)}`;
  }

  protected override cursorMark(at: Pixel, { scale }: Frame): unknown {
    return shapesOf(target('cursor', at), scale).map(drawn);
  }

  protected override above(frame: Frame): unknown {
    if (this.editing === null) return nothing;
    return html`<vidno-handles
      .editing=${this.editing}
      .frame=${frame}
      .language=${this.view.language}
      @follow=${({ detail }: CustomEvent<Point>) => this.follow(detail, 0)}
    ></vidno-handles>`;
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

declare global {
  interface HTMLElementTagNameMap {
    'vidno-picture': PictureElement;
  }
}
