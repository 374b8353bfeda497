import { LitElement, css, html, nothing, svg } from 'lit';
import type { PropertyValues, SVGTemplateResult, TemplateResult } from 'lit';
import { customElement, property, state } from 'lit/decorators.js';
import type { View } from '../algorithm/view.js';
import { Keyboard } from '../elements/keyboard.js';
import type { Actions } from '../elements/keyboard.js';
import { base, hiddenStyle } from '../elements/theme.js';
import { texts as allTexts } from '../i18n/index.js';
import { drawn } from '../picture/drawn.js';
import { Frame } from '../picture/frame.js';
import type { Zoom, Zooming } from '../picture/frame.js';
import { Gestures } from '../picture/gestures.js';
import { marksStyle } from '../picture/marks.style.js';
import { OwnSize } from '../picture/own-size.js';
import { pictureStyle } from '../picture/picture.style.js';
import '../picture/zoom-bar.js';
import { noDrawing } from './drawing.js';
import type { Drawing } from './drawing.js';
import { dotShapes, outlinesToPoint, textsOf, wires } from './overlay.js';
import { stepDrawing, stillDrawing } from './scene.js';
import type { Space } from './space.js';
import { Stage } from './stage.js';
import { extent, isSame, turned, viewNames, views } from './turn.js';
import type { Turn, ViewName } from './turn.js';

/** The looks of the 3D view, in addition to those of the picture. */
const solidStyle = css`
  :host {
    container-type: inline-size;
    padding: var(--bar, 2.5rem) 0 var(--foot, 0px);
  }
  :host([flat]) {
    --foot: 2.75rem;
  }
  canvas,
  svg {
    inset: var(--bar, 2.5rem) 0 auto;
    width: 100%;
    height: calc(100% - var(--bar, 2.5rem) - var(--foot, 0px));
  }
  canvas {
    object-fit: contain;
    pointer-events: none;
  }
  svg {
    cursor: grab;
    touch-action: none;
  }
  svg:active {
    cursor: grabbing;
  }
  .label {
    font-weight: 500;
    pointer-events: all;
  }
  .label.strong {
    font-weight: 700;
  }
  .views {
    display: var(--tools, flex);
    position: absolute;
    top: 0.375rem;
    left: 0.375rem;
    border: 1px solid var(--line);
    border-radius: 6px;
    overflow: hidden;
    background: var(--panel);
  }
  .views button {
    min-height: 1.75rem;
    padding: 0 0.35rem;
    border: 0;
    border-radius: 0;
    font-size: 0.75rem;
    white-space: nowrap;
  }
  .views button + button {
    border-left: 1px solid var(--line);
  }
  .views button[aria-pressed='true'] {
    background: var(--accent-wash);
    font-weight: 600;
  }
  .views :focus-visible {
    outline-offset: -3px;
  }
  @container (max-width: 320px) {
    vidno-zoom-bar {
      top: auto;
      bottom: calc(var(--foot, 0px) + 0.375rem);
    }
  }
  .missing {
    position: absolute;
    inset: auto 0 0;
    height: var(--foot);
    padding: 0.3rem 0.75rem;
    background: var(--warn-wash);
    color: var(--warn);
    font-size: 0.75rem;
  }
  @media print {
    :host {
      --bar: 0px;
    }
    canvas {
      display: block;
    }
  }
`;

/** Degrees per CSS pixel of a drag, and per key press. */
const degrees = { pixel: 0.5, key: 5 };
/** CSS pixels per key press. */
const way = 40;
/** The zoom factor of a key or a button. */
const zoomStep = 1.5;

/** The box with the scene in it, drawn only when something about it changes. It can be turned, zoomed and moved. */
@customElement('vidno-solid-stage')
export class SolidStageElement extends LitElement {
  static override styles = [base, hiddenStyle, marksStyle, pictureStyle, solidStyle];

  @property({ attribute: false }) view!: View;
  @property({ attribute: false }) space!: Space;
  @state() private turn: Turn = views.askew;
  @state() private zoom: Zoom | null = null;

  private stage: Stage | null = null;
  private still: Drawing = noDrawing;
  private step: Drawing = noDrawing;
  private readonly size = new OwnSize(this);
  private readonly gestures = new Gestures(
    () => this.frame,
    (frame) => (this.zoom = frame.zoom),
    (dx, dy) => this.turnBy(-dx * degrees.pixel, dy * degrees.pixel),
  );

  constructor() {
    super();
    new Keyboard(this, ({ shiftKey }) => this.keys(shiftKey));
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.stage = Stage.on(this);
    this.toggleAttribute('flat', this.stage === null);
    this.stage?.canvas.addEventListener('webglcontextrestored', () => this.requestUpdate());
    this.requestUpdate('space');
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.stage?.dispose();
    this.stage = null;
  }

  private get frame(): Frame {
    const { space, turn, size, zoom } = this;
    return new Frame(extent(turn, space.size), size.value, zoom);
  }

  override willUpdate(changed: PropertyValues<this>): void {
    const { view, space } = this;
    if (changed.has('space')) this.still = stillDrawing(view, space);
    if (changed.has('view')) this.step = stepDrawing(view, space);
  }

  override updated(changed: PropertyValues<this>): void {
    const { stage, view, space, size } = this;
    if (stage === null) return;
    if (changed.has('space')) stage.setStill(this.still, space);
    if (changed.has('space') || changed.has('view')) stage.setStep(this.step, view.screen);
    stage.draw(this.frame, this.turn, space, window.devicePixelRatio * size.zoom);
  }

  private turnBy(right: number, above: number): void {
    this.turn = turned(this.turn, { right, above });
  }

  private zoomTo(to: Zooming): void {
    if (to === 'whole' || to === 'all') this.zoom = null;
    else this.zoom = this.frame.zoomed(to === 'in' ? zoomStep : 1 / zoomStep).zoom;
  }

  private moveBy(dx: number, dy: number): void {
    this.zoom = this.frame.moved(dx, dy).zoom;
  }

  /** Arrow keys have the same effect as dragging in their direction. */
  private keys(shift: boolean): Actions {
    const drag = (across: number, down: number) => (): void => {
      if (shift) this.moveBy(across * way, down * way);
      else this.turnBy(-across * degrees.key, down * degrees.key);
    };
    return {
      ArrowLeft: drag(-1, 0),
      ArrowRight: drag(1, 0),
      ArrowUp: drag(0, -1),
      ArrowDown: drag(0, 1),
      '+': () => this.zoomTo('in'),
      '=': () => this.zoomTo('in'),
      '-': () => this.zoomTo('out'),
      '0': () => this.look('askew'),
    };
  }

  private look(name: ViewName): void {
    this.turn = views[name];
    this.zoom = null;
  }

  /** A mouse press must not take the focus, because arrow keys would no longer be steps. */
  private readonly keepFocus = (event: Event): void => event.preventDefault();

  override render(): TemplateResult {
    const { frame, gestures, stage } = this;
    const { picture, solid } = allTexts[this.view.language];
    return html`
      ${stage?.canvas}
      <svg
        viewBox=${frame.shown.join(' ')}
        role="application"
        tabindex="0"
        aria-label=${solid.title}
        aria-describedby="how"
        @mousedown=${this.keepFocus}
        @wheel=${{ handleEvent: gestures.onWheel, passive: false }}
        @pointerdown=${gestures.onDown}
        @pointermove=${gestures.onMove}
        @pointerup=${gestures.onEnd}
        @pointercancel=${gestures.onEnd}
      >
        ${this.shapes(frame)} ${this.texts(frame)}
      </svg>
      <div class="views" role="group" aria-label=${solid.turn}>
        ${viewNames.map((name) => this.button(name, solid.views[name]))}
      </div>
      <vidno-zoom-bar
        .frame=${frame}
        .texts=${picture}
        @zoom=${({ detail }: CustomEvent<Zooming>) => this.zoomTo(detail)}
      ></vidno-zoom-bar>
      ${stage === null ? html`<p class="missing">${solid.missing}</p>` : nothing}
      <p class="heard" id="how">${solid.how}</p>
    `;
  }

  private button(name: ViewName, label: string): TemplateResult {
    const isOn = isSame(this.turn, views[name]);
    return html`<button aria-pressed=${isOn ? 'true' : 'false'} @click=${() => this.look(name)}>
      ${label}
    </button>`;
  }

  private shapes(frame: Frame): readonly SVGTemplateResult[] {
    const { turn, still, step, stage, space, view } = this;
    const lines = stage === null ? [...still.lines, ...step.lines] : [];
    return [
      ...wires(lines, turn),
      ...outlinesToPoint(view.header.scene, space, turn),
      ...dotShapes(step.dots, turn, frame),
    ].map(drawn);
  }

  private texts(frame: Frame): readonly SVGTemplateResult[] {
    return textsOf([...this.still.labels, ...this.step.labels], this.turn, frame).map(
      ({ label: { text, strong, thing }, x, y, size }) =>
        svg`<text
          class="label ${strong === true ? 'strong' : ''}"
          data-thing=${thing ?? nothing}
          x=${x}
          y=${y}
          font-size=${size}
        >${text}</text>`,
    );
  }
}
