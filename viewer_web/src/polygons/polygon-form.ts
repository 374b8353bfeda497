import { html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, state } from 'lit/decorators.js';
import { live } from 'lit/directives/live.js';
import * as sketch from '../run/sketch.js';
import type { Sketch, Spot } from '../run/sketch.js';
import { polygonThing } from '../algorithm/pointed.js';
import type { Polygon } from '../trace/header.js';
import { FormElement } from '../editor/form.js';
import { formStyle } from '../elements/form.style.js';
import { base } from '../elements/theme.js';

const mostPolygons = 200;
const axes = ['x', 'y', 'z'] as const;
type Axis = (typeof axes)[number];
const flatAxes = ['x', 'y'] as const;

/** The polygons in order, with all coordinates of the chosen one. */
@customElement('vidno-polygon-form')
export class PolygonFormElement extends FormElement {
  static override styles = [base, formStyle];

  /** The polygons whose vertices have their depths shown on request. */
  @state() private tilted: ReadonlySet<string> = new Set();

  override render(): TemplateResult {
    const { say, editing } = this;
    const { polygons } = editing.sketch;
    const shown = polygons.slice(0, mostPolygons);
    const left = polygons.length - shown.length;
    return html`<section>
      <h3>${say.polygons} <small>${say.order}</small></h3>
      <ol>
        ${shown.map((polygon, i) => this.polygon(polygon, i))}
      </ol>
      ${left > 0 ? html`<p>${say.more(left)}</p>` : nothing}
    </section>`;
  }

  private polygon(polygon: Polygon, i: number): TemplateResult {
    const { say, editing } = this;
    const { id, color, vertices } = polygon;
    const isOpen = editing.chosen?.polygon === i;
    const last = editing.sketch.polygons.length - 1;
    return html`<li data-thing=${polygonThing(id)}>
      <div class="polygon">
        <input
          type="color"
          .value=${color}
          aria-label=${say.colorOf(id)}
          title=${say.colorOf(id)}
          @input=${(event: Event) =>
            this.color(event, id, (value) => (old) => sketch.recolor(old, i, value))}
        />
        <input
          class="name"
          .value=${live(id)}
          maxlength="64"
          aria-label=${say.nameOf(id)}
          @input=${({ target }: Event) => (target as HTMLInputElement).setCustomValidity('')}
          @change=${(event: Event) => this.rename(event, i)}
        />
        <button
          class="corners"
          aria-expanded=${isOpen ? 'true' : 'false'}
          aria-label=${say.cornersOf(id)}
          title=${say.cornersOf(id)}
          @click=${() => this.act({ do: 'choose', spot: isOpen ? null : { polygon: i, vertex: 0 } })}
        >
          ${vertices.length} ${isOpen ? '▴' : '▾'}
        </button>
        ${this.small('↑', say.earlier(id), i === 0, (old) => sketch.reorder(old, i, -1))}
        ${this.small('↓', say.later(id), i === last, (old) => sketch.reorder(old, i, 1))}
        ${this.small('✕', say.remove(id), false, (old) => sketch.removePolygon(old, i))}
      </div>
      ${isOpen ? this.details(polygon, i) : nothing}
    </li>`;
  }

  /** A name that is empty or taken stays in its field, which says so. */
  private rename({ target }: Event, i: number): void {
    const field = target as HTMLInputElement;
    const id = field.value.trim();
    if (sketch.isFree(this.editing.sketch, i, id)) {
      this.edit((old) => sketch.rename(old, i, id));
      this.requestUpdate();
    } else {
      field.setCustomValidity(id === '' ? this.say.needsName : this.say.isTaken(id));
      field.reportValidity();
    }
  }

  /** The depth of the polygon, and its vertices, with depths of their own only if it is tilted or is to be. */
  private details(polygon: Polygon, i: number): TemplateResult {
    const { say, editing } = this;
    const depth = sketch.depthOf(editing.sketch, i);
    if (depth === null || this.tilted.has(polygon.id)) return this.vertices(polygon, i, axes);
    return html`<div class="depth">
        <label
          >${say.depth}
          <input
            type="number"
            step="0.0625"
            aria-label=${say.depthOf(polygon.id)}
            .value=${live(String(depth))}
            @change=${(event: Event) =>
              this.number(event, (z) => this.edit((old) => sketch.setDepthOfAll(old, i, z)))}
        /></label>
        <button @click=${() => (this.tilted = new Set(this.tilted).add(polygon.id))}>
          ${say.tilt}
        </button>
      </div>
      ${this.vertices(polygon, i, flatAxes)}`;
  }

  private vertices(
    { id, vertices }: Polygon,
    polygon: number,
    shown: readonly Axis[],
  ): TemplateResult {
    const own = sketch.anchors(vertices);
    const follows = (i: number): boolean => vertices.length > 3 && own?.includes(i) === false;
    return html`<table aria-label=${this.say.cornersOf(id)}>
      <thead>
        <tr>
          <td></td>
          ${shown.map((axis) => html`<th scope="col">${axis}</th>`)}
          <td></td>
        </tr>
      </thead>
      <tbody>
        ${vertices.map((vertex, i) =>
          this.vertex(vertex, { polygon, vertex: i }, shown, follows(i), vertices.length > 3),
        )}
      </tbody>
    </table>`;
  }

  private vertex(
    vertex: sketch.Vertex,
    spot: Spot,
    shown: readonly Axis[],
    follows: boolean,
    mayGo: boolean,
  ): TemplateResult {
    const { say, editing } = this;
    const n = spot.vertex + 1;
    return html`<tr class=${editing.chosen?.vertex === spot.vertex ? 'chosen' : ''}>
      <th scope="row">${n}</th>
      ${shown.map((axis, a) => this.coordinate(spot, axis, vertex[a] ?? 0, follows))}
      <td class="row-tools">
        ${this.small('+', say.split(n), false, (old) => sketch.splitEdge(old, spot))}
        ${this.small('−', say.removeCorner(n), !mayGo, (old) => sketch.removeVertex(old, spot))}
      </td>
    </tr>`;
  }

  private coordinate(spot: Spot, axis: Axis, value: number, follows: boolean): TemplateResult {
    const { say } = this;
    const isFixed = axis === 'z' && follows;
    return html`<td>
      <input
        type="number"
        step=${axis === 'z' ? '0.0625' : '0.25'}
        .value=${live(String(value))}
        ?readonly=${isFixed}
        title=${isFixed ? say.follows : nothing}
        aria-label=${say.coordinate(axis, spot.vertex + 1)}
        @focus=${() => this.act({ do: 'choose', spot })}
        @change=${(event: Event) =>
          this.number(event, (typed) => this.edit((old) => placed(old, spot, axis, typed)))}
      />
    </td>`;
  }

  private small(
    sign: string,
    label: string,
    off: boolean,
    edit: (old: Sketch) => Sketch,
  ): TemplateResult {
    return html`<button
      class="small"
      aria-label=${label}
      title=${label}
      ?disabled=${off}
      @click=${() => this.edit(edit)}
    >
      ${sign}
    </button>`;
  }
}

function placed(old: Sketch, spot: Spot, axis: Axis, value: number): Sketch {
  if (axis === 'z') return sketch.setDepth(old, spot, value);
  const [x, y] = old.polygons[spot.polygon]?.vertices[spot.vertex] ?? [0, 0];
  return axis === 'x'
    ? sketch.moveVertex(old, spot, value, y)
    : sketch.moveVertex(old, spot, x, value);
}
