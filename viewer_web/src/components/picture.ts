import { LitElement, html, nothing, svg } from 'lit';
import type { PropertyValues, SVGTemplateResult, TemplateResult } from 'lit';
import { customElement, property, query, state } from 'lit/decorators.js';
import { guard } from 'lit/directives/guard.js';
import { marksOf } from '../picture/marks.js';
import type { Mark } from '../picture/marks.js';
import { paint } from '../picture/paint.js';
import type { Polygon } from '../trace/header.js';
import type { View } from '../view.js';
import { marksStyle, pictureStyle } from './picture.style.js';
import { base } from './theme.js';

const mostLabels = 26;
const mostOutlines = 3000;
const many = 40;
const gridFrom = 7;

interface Size {
  readonly width: number;
  readonly height: number;
}

/** The picture so far, and over it what the step is about. */
@customElement('vidno-picture')
export class PictureElement extends LitElement {
  static override styles = [base, marksStyle, pictureStyle];

  @property({ attribute: false }) view!: View;
  @state() private size: Size = { width: 0, height: 0 };
  @query('canvas') private canvas!: HTMLCanvasElement;

  private readonly observer = new ResizeObserver(([entry]) => {
    if (entry) this.size = { width: entry.contentRect.width, height: entry.contentRect.height };
  });

  override connectedCallback(): void {
    super.connectedCallback();
    this.observer.observe(this);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.observer.disconnect();
  }

  /** What of the plane is shown: the area and a margin around it. */
  private get shown(): readonly [number, number, number, number] {
    const { x, y, width, height } = this.view.header.scene.area;
    const margin = Math.max(width, height) * 0.07;
    return [x - margin, y - margin, width + 2 * margin, height + 2 * margin];
  }

  /** CSS pixels per unit of the plane. */
  private get scale(): number {
    const [, , width, height] = this.shown;
    return Math.max(Math.min(this.size.width / width, this.size.height / height), 1e-6);
  }

  override updated(changed: PropertyValues<this>): void {
    super.updated(changed);
    this.paint();
  }

  private paint(): void {
    const [x, y, width, height] = this.shown;
    const { area } = this.view.header.scene;
    const ratio = window.devicePixelRatio;
    const { canvas, size, scale } = this;
    canvas.width = Math.round(size.width * ratio);
    canvas.height = Math.round(size.height * ratio);
    const left = (size.width - width * scale) / 2;
    const top = (size.height - height * scale) / 2;
    paint(canvas, this.view.screen.picture, {
      x: Math.round((left + (area.x - x) * scale) * ratio),
      y: Math.round((top + (area.y - y) * scale) * ratio),
      width: Math.round(area.width * scale * ratio),
      height: Math.round(area.height * scale * ratio),
    });
  }

  override render(): TemplateResult {
    const { header, texts, language } = this.view;
    return html`
      <canvas aria-hidden="true"></canvas>
      <svg
        viewBox=${this.shown.join(' ')}
        role="img"
        aria-label="${texts.picture}: ${header.scene.name}"
      >
        ${guard([header, this.scale, language], () => this.still())}
        ${marksOf(this.view).map((mark) => this.mark(mark))}
        ${guard([header, this.scale], () => this.labels())}
      </svg>
    `;
  }

  /** What does not change from step to step. */
  private still(): SVGTemplateResult {
    const { area, polygons } = this.view.header.scene;
    const { x, y, width, height } = area;
    return svg`
      ${this.scale >= gridFrom ? this.grid() : nothing}
      <rect class="area" x=${x} y=${y} width=${width} height=${height} />
      <g class=${polygons.length > many ? 'many' : nothing}>
        ${polygons.slice(0, mostOutlines).map((polygon) => outline(polygon))}
      </g>
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
    const [x, y] = labelSpot(vertices, this.shown);
    return svg`<text class="label" x=${x} y=${y} font-size=${13 / this.scale}>${id}</text>`;
  }

  private mark(mark: Mark): SVGTemplateResult {
    if (mark.kind === 'box') {
      const [x, y, width, height] = mark.box;
      return svg`<rect class="casing ${mark.role}" x=${x} y=${y} width=${width} height=${height} />
        <rect class=${mark.role} x=${x} y=${y} width=${width} height=${height} />`;
    }
    if (mark.kind === 'point') {
      const [x, y] = mark.at;
      return svg`<circle class="dot ${mark.role}" cx=${x} cy=${y} r=${5 / this.scale} />`;
    }
    const d = pathData(mark.points, mark.closed);
    return svg`<path class="casing ${mark.role}" d=${d} />
      <path class=${mark.role} d=${d} stroke=${mark.color ?? nothing} />`;
  }
}

function pathData(points: readonly (readonly number[])[], closed: boolean): string {
  if (points.length === 0) return '';
  return `M${points.map(([x = 0, y = 0]) => `${x} ${y}`).join('L')}${closed ? 'Z' : ''}`;
}

function outline({ vertices, color }: Polygon): SVGTemplateResult {
  const d = pathData(vertices, true);
  return svg`<path class="outline-casing" d=${d} /><path class="outline" d=${d} stroke=${color} />`;
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
