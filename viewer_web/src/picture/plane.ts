import { LitElement, html, nothing } from 'lit';
import type { PropertyValues, TemplateResult } from 'lit';
import { property, query, state } from 'lit/decorators.js';
import type { View } from '../algorithm/view.js';
import { Keyboard } from '../elements/keyboard.js';
import type { Actions } from '../elements/keyboard.js';
import { texts } from '../i18n/index.js';
import { nameIn } from '../language/scene-name.js';
import type { HistoryTexts } from '../language/texts.js';
import type { Area, Scene } from '../trace/header.js';
import './axes.js';
import type { Numbered } from './axes.js';
import { Frame, marginIn } from './frame.js';
import type { Point, Rectangle, Zoom, Zooming } from './frame.js';
import { Gestures } from './gestures.js';
import { OwnSize, pointIn } from './own-size.js';
import { isIn, isOther, moved, nearestIn } from './pixel.js';
import type { Pixel } from './pixel.js';
import { extended } from './target.js';
import './targets-element.js';
import './zoom-bar.js';

const known = new WeakMap<Scene, Rectangle>();

/** The extent of a scene: the area and all vertices, even those outside. The same scene always gives the same object. */
function extentOf(scene: Scene): Rectangle {
  const found = known.get(scene) ?? boundsOf(scene);
  known.set(scene, found);
  return found;
}

function boundsOf({ area, polygons }: Scene): Rectangle {
  let [left, top] = [area.x, area.y];
  let [right, bottom] = [area.x + area.width, area.y + area.height];
  for (const { vertices } of polygons) {
    for (const [x, y] of vertices) {
      left = Math.min(left, x);
      right = Math.max(right, x);
      top = Math.min(top, y);
      bottom = Math.max(bottom, y);
    }
  }
  return [left, top, right - left, bottom - top];
}

/** The factor by which a key or a button magnifies the picture. */
const zoomStep = 1.5;

/**
 * The plane of the scene in a box of the page. The reader can choose a place in it by mouse or keyboard, zoom it and move
 * it. Subclasses draw its content.
 */
export abstract class PlaneElement extends LitElement {
  @property({ attribute: false }) view!: View;
  /** The keyboard cursor of the choice, while the picture has the focus. */
  @state() protected cursor: Pixel | null = null;
  /** The pixel under the pointer; an event `pointed` reports it. */
  @state() private pointed: Pixel | null = null;
  /** The pixel under the pointer before the page shows it. */
  private underPointer: Pixel | null = null;
  /** The visible part of the picture. */
  @state() private zoom: Zoom | null = null;
  @query('svg') private stage!: SVGSVGElement;

  protected readonly size = new OwnSize(this);
  private readonly gestures = new Gestures(
    () => this.frame,
    (frame) => (this.zoom = frame.zoom),
  );
  private known: Frame | null = null;
  private sized = this.size.value;
  private left: Pixel | null = null;
  /** The extent of the scene and of targets outside the area, while there are any. */
  private reach: Rectangle | null = null;

  constructor() {
    super();
    new Keyboard(this, () => this.zoomKeys());
    this.addEventListener('pointermove', this.onMove, { capture: true });
    this.addEventListener('pointermove', this.onPoint);
    this.addEventListener('pointerleave', this.onPoint);
    this.addEventListener('wheel', this.gestures.onWheel, { passive: false });
  }

  /** The frame, the same object as long as nothing about it changes. */
  protected get frame(): Frame {
    const { size, zoom, known } = this;
    const { scene } = this.view.header;
    const { area } = scene;
    const extent = this.reach ?? extentOf(scene);
    const isSame =
      known?.area === area &&
      known.extent === extent &&
      known.size === size.value &&
      known.wanted === zoom;
    if (isSame) return known;
    return (this.known = new Frame(area, size.value, zoom, extent, marginIn(size.value, area)));
  }

  /** Moves the focus to the picture, to choose a place. */
  startChoosing(): void {
    this.stage.focus();
  }

  /**
   * The layers over the plane have the last reported size. The browser tries other sizes during a layout, and would lay out
   * the whole drawing for each of them.
   */
  override updated(changed: PropertyValues<this>): void {
    super.updated(changed);
    const { width, height } = this.size.value;
    if (this.sized === this.size.value || width === 0 || height === 0) return;
    this.sized = this.size.value;
    this.style.setProperty('--across', `${width}px`);
    this.style.setProperty('--down', `${height}px`);
  }

  override willUpdate(changed: PropertyValues<this>): void {
    const before = changed.get('view')?.header.scene.area;
    if (before && isOtherArea(before, this.view.header.scene.area)) this.zoom = null;
    this.showTargets();
  }

  /** Zooms out as long as there are targets outside the area. */
  private showTargets(): void {
    const { targets = [], header } = this.view;
    const { whole } = this.frame;
    const isWide = extended(whole, targets) !== whole;
    const reach = isWide ? extended(extentOf(header.scene), targets) : null;
    if (reach?.join() === this.reach?.join()) return;
    this.reach = reach;
    this.zoom = reach && this.frame.all;
  }

  /** What the numbers along the area belong to. */
  protected readonly numbered: Numbered = 'pixels';

  /** The drawing in the plane. */
  protected abstract drawing(frame: Frame): unknown;
  /** The mark of the keyboard cursor. */
  protected abstract cursorMark(at: Pixel, frame: Frame): unknown;
  /** The texts about places. */
  protected abstract readonly words: Pick<HistoryTexts, 'at' | 'how'>;
  /** The text about the place of the keyboard cursor. */
  protected spoken(at: Pixel): string {
    return this.words.at(...at);
  }

  /** The layers under the drawing and above it. */
  protected below?(): unknown;
  protected above?(frame: Frame): unknown;

  /** The place under a point of the box. */
  protected placeAt(point: Point): Pixel {
    return this.frame.pixelAt(...point);
  }

  private zoomTo(way: Zooming): void {
    const { frame } = this;
    if (way === 'whole') this.zoom = null;
    else if (way === 'all') this.zoom = frame.all;
    else this.zoom = frame.zoomed(way === 'in' ? zoomStep : 1 / zoomStep).zoom;
  }

  private zoomKeys(): Actions {
    return {
      '+': () => this.zoomTo('in'),
      '=': () => this.zoomTo('in'),
      '-': () => this.zoomTo('out'),
      '0': () => this.zoomTo(this.frame.zoom === null ? 'all' : 'whole'),
    };
  }

  /** Moves the plane to show the place in focus: a pixel or a point. */
  protected follow(at: Point, side: number): void {
    this.zoom = this.frame.showing(at, side).zoom;
  }

  /** A mouse press must not take the focus, because arrow keys would no longer be steps. */
  private readonly keepFocus = (event: Event): void => event.preventDefault();

  /** Finds the place before other listeners change the page: later, the browser would have to lay it out first. */
  private readonly onMove = (event: PointerEvent): void => {
    const place = this.placeAt(pointIn(this, event));
    this.underPointer = isIn(place, this.view.header.scene.area) ? place : null;
  };

  private readonly onPoint = ({ type }: PointerEvent): void => {
    const pixel = type === 'pointerleave' ? null : this.underPointer;
    if (!isOther(pixel, this.pointed)) return;
    this.pointed = pixel;
    this.dispatchEvent(
      new CustomEvent('pointed', { detail: pixel, bubbles: true, composed: true }),
    );
  };

  private onClick(event: MouseEvent): void {
    if (this.gestures.dragged) return;
    const place = this.placeAt(pointIn(this, event));
    if (isIn(place, this.view.header.scene.area)) this.choose(place);
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

  private targets(frame: Frame): TemplateResult | typeof nothing {
    const { targets = [] } = this.view;
    if (targets.length === 0) return nothing;
    return html`<vidno-targets .targets=${targets} .frame=${frame}></vidno-targets>`;
  }

  override render(): TemplateResult {
    const { frame, gestures, cursor, words } = this;
    const { header, texts: page, language } = this.view;
    return html`
      ${this.below?.()}
      <svg
        viewBox=${frame.shown.join(' ')}
        class=${frame.zoom === null ? nothing : 'zoomed'}
        role="application"
        tabindex="0"
        aria-label="${page.picture}: ${nameIn(language, header.scene.name)}"
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
        ${this.drawing(frame)} ${cursor === null ? nothing : this.cursorMark(cursor, frame)}
      </svg>
      <vidno-axes
        .frame=${frame}
        .pointed=${cursor ?? this.pointed}
        .numbered=${this.numbered}
      ></vidno-axes>
      ${this.above?.(frame)} ${this.targets(frame)}
      <vidno-zoom-bar
        .frame=${frame}
        .texts=${texts[language].picture}
        @zoom=${({ detail }: CustomEvent<Zooming>) => this.zoomTo(detail)}
      ></vidno-zoom-bar>
      <p class="heard" id="how">${words.how}</p>
      <p class="heard" aria-live="polite">${cursor === null ? '' : this.spoken(cursor)}</p>
    `;
  }
}

const isOtherArea = (a: Area, b: Area): boolean =>
  a.x !== b.x || a.y !== b.y || a.width !== b.width || a.height !== b.height;
