import { html, nothing, svg } from 'lit';
import type {
  PropertyValues,
  ReactiveController,
  ReactiveControllerHost,
  SVGTemplateResult,
} from 'lit';
import { customElement, property, query } from 'lit/decorators.js';
import { guard } from 'lit/directives/guard.js';
import type { Editing } from '../editor/editor.js';
import { base, hiddenStyle } from '../elements/theme.js';
import { texts } from '../i18n/index.js';
import type { HistoryTexts } from '../language/texts.js';
import { sceneDrawing, stepDrawing } from '../picture/drawing.js';
import type { Drawing } from '../picture/drawing.js';
import { drawn, labels } from '../picture/drawn.js';
import type { Frame, Point } from '../picture/frame.js';
import { Inker, fit } from '../picture/ink.js';
import { cellsOf } from '../picture/layers.js';
import type { Exact, Layer } from '../picture/layers.js';
import { target } from '../picture/mark.js';
import { marksStyle } from '../picture/marks.style.js';
import { CellPainter } from '../picture/paint.js';
import type { Cells } from '../picture/paint.js';
import { patchesOf } from '../picture/patches.js';
import { pictureStyle } from '../picture/picture.style.js';
import { factsIn } from '../picture/pixel-facts.js';
import type { Pixel } from '../picture/pixel.js';
import { PlaneElement } from '../picture/plane.js';
import { shapesOf } from '../picture/shapes.js';
import type { Shape } from '../picture/shapes.js';
import { labelsOf, shapesToPoint } from '../picture/still.js';
import type { Label } from '../picture/still.js';
import type { Scene } from '../trace/header.js';
import './handles.js';

/** Whether the page is being printed. The drawings for paper are made only then. */
class Printing implements ReactiveController {
  now = false;

  constructor(private readonly host: ReactiveControllerHost) {
    host.addController(this);
  }

  hostConnected(): void {
    window.addEventListener('beforeprint', this.follow);
    window.addEventListener('afterprint', this.follow);
  }

  hostDisconnected(): void {
    window.removeEventListener('beforeprint', this.follow);
    window.removeEventListener('afterprint', this.follow);
  }

  private readonly follow = ({ type }: Event): void => {
    this.now = type === 'beforeprint';
    this.host.requestUpdate();
  };
}

const none: readonly Shape[] = [];

/** Whether a shape shows the division of the area; those lie under all marks. */
const isOfTree = ({ look }: Shape): boolean => look === 'tree' || look === 'casing tree';

/** A drawing, and the values that it depends on. */
interface SceneDrawing {
  readonly shapes: readonly Shape[];
  readonly scene: Scene;
  readonly frame: Frame;
  readonly under: readonly Shape[];
}

/**
 * The picture so far, and the marks of the step over it. Everything except names and pointed things is drawn on canvases:
 * the browser would lay out outlines and windows at each step if they were elements. For print they are elements, so that
 * they are as sharp as the print.
 */
@customElement('vidno-picture')
export class PictureElement extends PlaneElement {
  static override styles = [base, hiddenStyle, marksStyle, pictureStyle];

  /** The layer that the pixels show. */
  @property({ attribute: false }) layer: Layer = 'picture';
  @property({ attribute: false }) exact: Exact = null;
  /** The scene, while its corners can be dragged. */
  @property({ attribute: false }) editing: Editing | null = null;
  @query('.cells') private bottom!: HTMLCanvasElement;
  @query('.scene') private scene!: HTMLCanvasElement;
  @query('.tree') private tree!: HTMLCanvasElement;
  @query('.step') private step!: HTMLCanvasElement;

  private readonly printing = new Printing(this);
  private readonly painter = new CellPainter();
  private readonly inkers = { scene: new Inker(), tree: new Inker(), step: new Inker() };
  private ofScene: SceneDrawing | null = null;
  private ofStep: Drawing = { shapes: none, labels: [] };
  /** The names of the polygons, and what their places depend on. */
  private names: readonly Label[] = [];
  private namedIn: readonly unknown[] = [];

  /** The shapes over the pixels, from bottom to top. */
  get shapes(): readonly Shape[] {
    return [...(this.ofScene?.shapes ?? none), ...this.ofStep.shapes];
  }

  override willUpdate(changed: PropertyValues<this>): void {
    super.willUpdate(changed);
    const { view, frame } = this;
    this.ofScene = this.drawingOfScene(frame);
    this.ofStep = stepDrawing(view, frame, this.over?.(frame));
    this.placeNames(frame);
  }

  /** Moves the names that do not stand on their polygons any more, if the pixels may differ. */
  private placeNames(frame: Frame): void {
    const { scene } = this.view.header;
    const { picture } = this.view.screen;
    const now = [scene, frame, picture.version];
    if (now.every((each, i) => each === this.namedIn[i])) return;
    const isMoved = scene !== this.namedIn[0] || frame !== this.namedIn[1];
    this.names = labelsOf(scene, frame, picture, isMoved ? [] : this.names);
    this.namedIn = now;
  }

  /** The drawing of the scene, the same object as long as nothing about it changes. */
  private drawingOfScene(frame: Frame): SceneDrawing {
    const { ofScene: known } = this;
    const { scene } = this.view.header;
    const under = this.under();
    const isSame = known?.scene === scene && known.frame === frame && known.under === under;
    return isSame ? known : { scene, frame, under, shapes: sceneDrawing(scene, frame, under) };
  }

  override updated(changed: PropertyValues<this>): void {
    super.updated(changed);
    const { frame, bottom, scene, tree, step, inkers } = this;
    const ratio = window.devicePixelRatio * this.size.zoom;
    for (const canvas of [bottom, scene, tree, step]) fit(canvas, frame.size, ratio);
    this.painter.paint(bottom, this.cells, frame.place(ratio));
    inkers.scene.draw(scene, this.ofScene?.shapes ?? none, frame, ratio);
    const { shapes } = this.ofStep;
    // There may be thousands of windows, and few steps add one.
    inkers.tree.draw(tree, shapes.filter(isOfTree), frame, ratio);
    inkers.step.draw(
      step,
      shapes.filter((shape) => !isOfTree(shape)),
      frame,
      ratio,
    );
  }

  /** The cells that the pixels show; null for none. */
  protected get cells(): Cells | null {
    return cellsOf(this.layer, this.view.screen, this.exact);
  }

  /** The shapes over the pixels and under the polygons' outlines. */
  protected under(): readonly Shape[] {
    return none;
  }

  /** The shapes over these and under the marks. */
  protected over?(frame: Frame): readonly Shape[];

  protected override get words(): HistoryTexts {
    return texts[this.view.language].history;
  }

  protected override spoken(at: Pixel): string {
    return this.words.spoken(at, factsIn(this.view, at));
  }

  protected override below(): unknown {
    return html`<canvas class="cells" aria-hidden="true"></canvas>
      <canvas class="scene" aria-hidden="true"></canvas>
      <canvas class="tree" aria-hidden="true"></canvas>
      <canvas class="step" aria-hidden="true"></canvas>`;
  }

  protected override drawing(frame: Frame): unknown {
    const { scene } = this.view.header;
    const { names, ofStep } = this;
    return svg`${this.printing.now ? this.onPaper() : nothing}
      ${guard([scene], () => shapesToPoint(scene).map(drawn))}
      ${guard([names, frame], () => labels(names, frame))}
      ${labels(ofStep.labels, frame)}`;
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

  /** The content of the canvases, as vectors for print. */
  private onPaper(): readonly SVGTemplateResult[] {
    const { screen, header } = this.view;
    const patches = this.cells === null ? [] : patchesOf(screen.picture, header.scene.area);
    return [
      ...patches.map(
        ({ color, d }) => svg`<path class="pixels" .style=${`fill: ${color}`} d=${d} />`,
      ),
      ...this.shapes.map(drawn),
    ];
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'vidno-picture': PictureElement;
  }
}
