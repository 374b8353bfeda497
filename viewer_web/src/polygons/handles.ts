import { LitElement, html, nothing, svg } from 'lit';
import type { PropertyValues, SVGTemplateResult, TemplateResult } from 'lit';
import { customElement, property, state } from 'lit/decorators.js';
import { texts } from '../i18n/index.js';
import type { Language } from '../language/language.js';
import { cornerAct, led, snapped } from '../editor/corner-keys.js';
import type { Place } from '../editor/corner-keys.js';
import type { Act, Corner, Editing } from '../editor/editor.js';
import { refusalOf } from '../run/refusal.js';
import * as sketch from '../run/sketch.js';
import type { Spot } from '../run/sketch.js';
import { overlayStyle } from '../picture/picture.style.js';
import type { Frame } from '../picture/frame.js';
import { pathData } from '../picture/shapes.js';
import type { Polygon } from '../trace/header.js';
import { act } from '../editor/form.js';
import { Dragging } from '../editor/dragging.js';
import { handlesStyle } from '../editor/handles.style.js';
import { base, hiddenStyle } from '../elements/theme.js';

const mostHandles = 400;
/** CSS pixels. */
const radius = 6;
const reach = 13;

/** The scene's corners over the picture, which can be dragged, and the outline that is being drawn. */
@customElement('vidno-handles')
export class HandlesElement extends LitElement {
  static override styles = [base, hiddenStyle, overlayStyle, handlesStyle];

  @property({ attribute: false }) editing!: Editing;
  /** The position of the plane in the picture. */
  @property({ attribute: false }) frame!: Frame;
  @property({ attribute: false }) language: Language = 'en';
  /** The place of the next corner. */
  @state() private pen: Place = [0, 0];

  private readonly dragging = new Dragging(this);
  /** The corner that the keyboard has moved since the last render. */
  private keyed: Spot | null = null;

  override updated(changed: PropertyValues<this>): void {
    super.updated(changed);
    if (!changed.has('editing')) return;
    const wasDrawing = changed.get('editing')?.drawn ?? null;
    if (wasDrawing === null && this.editing.drawn !== null) this.startDrawing();
    if (this.keyed !== null) this.followCorner(this.keyed);
    this.keyed = null;
  }

  private startDrawing(): void {
    this.pen = snapped(this.frame.middle, { altKey: false });
    this.renderRoot.querySelector<SVGElement>('.pen')?.focus();
  }

  override render(): TemplateResult {
    const { editing, frame } = this;
    const { polygons } = editing.sketch;
    const isDrawing = editing.drawn !== null;
    return html`<svg
      viewBox=${frame.shown.join(' ')}
      class=${isDrawing ? 'drawing' : ''}
      @pointerdown=${isDrawing ? this.setPoint : null}
      @pointermove=${isDrawing ? this.movePen : null}
    >
      ${isDrawing ? this.drawing() : polygons.slice(0, mostHandles).map((p, i) => this.corners(p, i))}
    </svg>`;
  }

  /** The polygon that the library refuses. */
  private get refused(): string | null {
    const { refused, messages, sketch: drawn } = this.editing;
    return refused ? refusalOf(messages, drawn).polygon : null;
  }

  private corners(polygon: Polygon, i: number): SVGTemplateResult {
    const { scale } = this.frame;
    const { chosen } = this.editing;
    const say = texts[this.language].scene;
    const outline = pathData(polygon.vertices, true);
    return svg`
      ${this.refused === polygon.id ? svg`<path class="casing" d=${outline} /><path class="line" d=${outline} />` : nothing}
      <path
        class="edge"
        d=${outline}
        @pointerdown=${(event: PointerEvent) => this.dragPolygon(event, i)}
      />
      ${polygon.vertices.map(([x, y, z], vertex) => {
        const spot = { polygon: i, vertex };
        const isChosen = chosen?.polygon === i && chosen.vertex === vertex;
        return svg`<g
          class=${isChosen ? 'handle chosen' : 'handle'}
          tabindex="0"
          role="button"
          aria-label=${say.corner(polygon.id, vertex + 1, x, y, z)}
          data-spot="${i},${vertex}"
          @pointerdown=${(event: PointerEvent) => this.dragVertex(event, spot)}
          @keydown=${(event: KeyboardEvent) => this.onKey(event, spot)}
          @focus=${() => this.onFocus(spot)}
        >
          <circle class="reach" cx=${x} cy=${y} r=${reach / scale} />
          <circle class="knob" cx=${x} cy=${y} r=${radius / scale} />
        </g>`;
      })}
    `;
  }

  private drawing(): SVGTemplateResult {
    const drawn = this.editing.drawn ?? [];
    const { scale } = this.frame;
    const { pen } = this;
    const say = texts[this.language].scene;
    const outline = pathData([...drawn, pen], false);
    return svg`
      <path class="casing" d=${outline} />
      <path class="line" d=${outline} />
      ${drawn.map(([x, y]) => svg`<circle class="knob" cx=${x} cy=${y} r=${radius / scale} />`)}
      <g
        class="pen"
        tabindex="0"
        role="application"
        aria-label=${say.drawHere}
        @keydown=${this.onDrawingKey}
      >
        <circle class="reach" cx=${pen[0]} cy=${pen[1]} r=${reach / scale} />
        <circle class="knob" cx=${pen[0]} cy=${pen[1]} r=${radius / scale} />
      </g>
    `;
  }

  private dragVertex(event: PointerEvent, spot: Spot): void {
    const vertex = this.editing.sketch.polygons[spot.polygon]?.vertices[spot.vertex];
    if (vertex === undefined) return;
    this.act({ do: 'choose', spot });
    const [x, y] = vertex;
    this.dragging.start(event, [x, y], (to, old) => sketch.moveVertex(old, spot, ...to));
  }

  private dragPolygon(event: PointerEvent, polygon: number): void {
    const from = this.editing.sketch;
    const first = from.polygons[polygon]?.vertices[0];
    if (first === undefined) return;
    this.act({ do: 'choose', spot: { polygon, vertex: 0 } });
    const [left, top] = first;
    this.dragging.start(event, [left, top], ([x, y]) =>
      sketch.movePolygon(from, polygon, x - left, y - top),
    );
  }

  private onKey(event: KeyboardEvent, spot: Spot): void {
    if (event.ctrlKey || event.metaKey) return;
    const what = cornerAct(event, spot);
    if (what === null) return;
    event.preventDefault();
    this.act(what);
    this.keyed = spot;
  }

  private onFocus(spot: Spot): void {
    this.act({ do: 'choose', spot });
    this.followCorner(spot);
  }

  private followCorner(spot: Spot): void {
    const vertex = this.editing.sketch.polygons[spot.polygon]?.vertices[spot.vertex];
    if (vertex !== undefined) this.follow([vertex[0], vertex[1]]);
  }

  /** Scrolls the focused corner into the picture. */
  private follow(detail: Place): void {
    this.dispatchEvent(new CustomEvent<Place>('follow', { detail }));
  }

  private movePenTo(to: Place): void {
    this.pen = to;
    this.follow(to);
  }

  private readonly movePen = (event: PointerEvent): void => {
    this.pen = this.dragging.placeOf(event);
  };

  private readonly setPoint = (event: PointerEvent): void => {
    if (event.button !== 0) return;
    event.preventDefault();
    this.point(this.dragging.placeOf(event));
  };

  private point(at: Place): void {
    const drawn: readonly Corner[] = this.editing.drawn ?? [];
    const [first] = drawn;
    const near = first && Math.hypot(first[0] - at[0], first[1] - at[1]) < reach / this.frame.scale;
    this.act(near && drawn.length > 2 ? { do: 'finish' } : { do: 'point', at });
  }

  private onDrawingKey(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey) return;
    const to = led(this.pen, event);
    if (to !== null) this.movePenTo(to);
    else if (event.key === ' ') this.point(this.pen);
    else if (event.key === 'Enter') this.act({ do: 'finish' });
    else if (event.key === 'Backspace') this.act({ do: 'unpoint' });
    else if (event.key === 'Escape') this.act({ do: 'cancel' });
    else return;
    event.preventDefault();
  }

  private act(what: Act): void {
    act(this, what);
  }
}
