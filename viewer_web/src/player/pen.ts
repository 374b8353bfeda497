import { LitElement, css, html, svg } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property, state } from 'lit/decorators.js';

export const tools = ['pointer', 'pen'] as const;
export type Tool = (typeof tools)[number];

type Point = readonly [x: number, y: number];

const pointOf = ({ clientX, clientY }: PointerEvent): Point => [clientX, clientY];

/** Covers a hall's screen: a spot that follows the mouse, or a pen that draws. What it has drawn goes with it. */
@customElement('vidno-pen')
export class PenElement extends LitElement {
  static override styles = css`
    :host {
      position: fixed;
      inset: 0;
      z-index: 11;
      pointer-events: none;
    }
    :host([tool='pen']) {
      cursor: crosshair;
      pointer-events: auto;
      touch-action: none;
    }
    svg {
      display: block;
      width: 100%;
      height: 100%;
    }
    circle {
      fill: rgb(255 20 50 / 80%);
      stroke: #ffffff;
    }
    polyline {
      fill: none;
      stroke: #e6001e;
      stroke-linecap: round;
      stroke-linejoin: round;
    }
  `;

  @property({ reflect: true }) tool: Tool = 'pointer';
  @state() private spot: Point | null = null;
  @state() private strokes: readonly (readonly Point[])[] = [];
  private isDrawing = false;

  override connectedCallback(): void {
    super.connectedCallback();
    window.addEventListener('pointermove', this.onMove);
    this.addEventListener('pointerdown', this.onDown);
    this.addEventListener('lostpointercapture', this.onUp);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    window.removeEventListener('pointermove', this.onMove);
    this.removeEventListener('pointerdown', this.onDown);
    this.removeEventListener('lostpointercapture', this.onUp);
  }

  /** In pixels of the screen, so that a magnified page changes nothing. A spot has a twentieth of its height. */
  override render(): TemplateResult {
    const spot = this.tool === 'pointer' ? this.spot : null;
    const { innerWidth: width, innerHeight: height } = window;
    return html`<svg viewBox="0 0 ${width} ${height}" aria-hidden="true">
      ${this.strokes.map((points) => svg`<polyline points=${points.join(' ')} stroke-width=${height / 120} />`)}
      ${spot && svg`<circle cx=${spot[0]} cy=${spot[1]} r=${height / 40} stroke-width=${height / 240} />`}
    </svg>`;
  }

  private readonly onMove = (event: PointerEvent): void => {
    if (this.isDrawing) this.draw([...(this.strokes.at(-1) ?? []), pointOf(event)]);
    else this.spot = pointOf(event);
  };

  private readonly onDown = (event: PointerEvent): void => {
    if (event.button !== 0) return;
    this.setPointerCapture(event.pointerId);
    this.isDrawing = true;
    this.strokes = [...this.strokes, []];
    // A stroke of one point is a dot.
    this.draw([pointOf(event), pointOf(event)]);
  };

  private readonly onUp = (): void => {
    this.isDrawing = false;
  };

  /** Gives the last stroke other points. */
  private draw(points: readonly Point[]): void {
    this.strokes = [...this.strokes.slice(0, -1), points];
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'vidno-pen': PenElement;
  }
}
