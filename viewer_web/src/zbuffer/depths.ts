import { LitElement, css, html } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { classMap } from 'lit/directives/class-map.js';
import { numbersOf } from '../algorithm/view.js';
import type { View } from '../algorithm/view.js';
import { base } from '../elements/theme.js';
import type { Numbers } from '../language/texts.js';
import { toNumber } from '../language/words.js';
import { keepsDepths } from '../replay/screen.js';
import type { N } from '../trace/values.js';
import { emptyZBuffer } from './state.js';

const columnsShown = 9;
const rowsShown = 7;
const rowsInHall = 3;

/** A range of cells around a focus, always of the same length, out of `size` cells. */
function around(focus: number, size: number, shown: number): readonly number[] {
  const count = Math.min(size, shown);
  const first = Math.max(0, Math.min(focus - Math.floor(count / 2), size - count));
  return Array.from({ length: count }, (_, i) => first + i);
}

/** From 0, far or not written yet, to 1, near: depths lie in [-1, 1]. */
function nearness(z: N): number {
  return Math.min(1, Math.max(0, (toNumber(z) + 1) / 2)) || 0;
}

/** Cells of the Z-buffer around the current row and column; nearer depths are darker. */
@customElement('vidno-depths')
export class DepthsElement extends LitElement {
  static override styles = [
    base,
    css`
      :host {
        display: block;
      }
      table {
        width: 100%;
        table-layout: fixed;
        border: 1px solid var(--line);
      }
      td,
      th {
        height: 1.45rem;
        padding: 0;
        overflow: hidden;
        text-align: center;
        font: 0.625rem var(--mono);
        letter-spacing: -0.03em;
        white-space: nowrap;
      }
      th {
        color: var(--soft);
      }
      td {
        border: 1px solid var(--line);
        background: color-mix(in srgb, var(--accent) calc(var(--near) * 60%), var(--panel));
      }
      .row th {
        color: var(--ink);
        font-weight: 700;
      }
      .row td {
        border-block: 2px solid var(--now-edge);
      }
      td.changed {
        outline: 2px solid var(--now-edge);
        outline-offset: -2px;
      }
      p {
        color: var(--soft);
        min-height: 12rem;
      }
      :host([hall]) :is(td, th) {
        height: 1.05rem;
        font-size: 0.75rem;
      }
      :host([hall]) {
        height: calc(${rowsInHall + 1} * 1.05rem + 5px);
        overflow: hidden;
      }
      :host([hall]) p {
        min-height: 0;
        font-size: 0.75rem;
      }
    `,
  ];

  @property({ attribute: false }) view!: View;

  override render(): TemplateResult {
    const { screen, header, after, hall } = this.view;
    const { z } = screen;
    if (z === null) return html`<p>${this.missing}</p>`;
    const { area } = header.scene;
    const { short } = numbersOf(this.view);
    const { row, last } = after.zbuffer ?? emptyZBuffer;
    const shown = (row ?? last.row ?? area.y) - area.y;
    const columns = around(this.column - area.x, area.width, columnsShown);
    return html`<table>
      <thead>
        <tr>
          <th></th>
          ${columns.map((i) => html`<th scope="col">${short(i + area.x)}</th>`)}
        </tr>
      </thead>
      <tbody>
        ${around(shown, area.height, hall === true ? rowsInHall : rowsShown).map(
          (j) =>
            html`<tr class=${classMap({ row: j + area.y === row })}>
              <th scope="row">${short(j + area.y)}</th>
              ${columns.map((i) => this.cell(z.at(i, j), this.isTouched(i + area.x, j + area.y)))}
            </tr>`,
        )}
      </tbody>
    </table>`;
  }

  /** Why there are no depths. */
  private get missing(): string {
    const { texts, header } = this.view;
    if (header.detail === 'windows') return texts.notInTrace;
    return keepsDepths(header) ? texts.none : texts.depthsTooMany;
  }

  /** The current column: that of the pixel, or the middle of the visible part of the row. */
  private get column(): number {
    const { event, after, header } = this.view;
    if (event?.e === 'pixel') return event.x;
    if (event?.e === 'columns') return event.first;
    const ends = (after.zbuffer?.ael ?? []).map(({ x }) => toNumber(x)).filter(Number.isFinite);
    const middle = ends.reduce((sum, x) => sum + x, 0) / ends.length;
    return Math.floor(ends.length > 0 ? middle : header.scene.area.x);
  }

  private isTouched(x: number, y: number): boolean {
    const { event } = this.view;
    if (event?.e === 'pixel') return event.x === x && event.y === y;
    if (event?.e !== 'span' || event.row !== y) return false;
    return event.runs.some(([first, end]) => first <= x && x < end);
  }

  private cell(z: N, changed: boolean): TemplateResult {
    return html`<td
      class=${classMap({ changed })}
      .style=${`--near: ${nearness(z)}`}
      title=${numbersOf(this.view).whole(z)}
    >
      ${tiny(z, numbersOf(this.view))}
    </td>`;
  }
}

/** A depth with two decimals, without the leading zero; `≈` if digits are missing. */
function tiny(z: N, { short }: Numbers): string {
  const value = toNumber(z);
  if (!Number.isFinite(value)) return short(z);
  const cut = Number(value.toFixed(2));
  return `${cut === value ? '' : '≈'}${short(cut)}`.replace(/0(?=[.,])/u, '');
}
