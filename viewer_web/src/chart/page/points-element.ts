import { LitElement, css, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { base } from '../../elements/theme.js';
import { byCost } from '../points.js';
import type { Point } from '../points.js';
import type { Shown } from '../shown.js';
import { costAmount, errorAmount, runDetails, runName } from '../words.js';
import { amount, tableStyle } from './table.js';

/** The points of the plot as a table, its text alternative. */
@customElement('vidno-points')
export class PointsElement extends LitElement {
  static override styles = [
    base,
    tableStyle,
    css`
      :host {
        display: block;
      }
      summary {
        min-height: 1.6em;
        cursor: pointer;
      }
    `,
  ];

  @property({ attribute: false }) shown!: Shown;
  @property({ attribute: false }) chosen: Point | null = null;

  override render(): TemplateResult {
    const { texts, visible, cost, error } = this.shown;
    return html`<details>
      <summary>${texts.table}</summary>
      <table>
        <thead>
          <tr>
            <th scope="col">${texts.run}</th>
            <th scope="col">${texts.costs[cost].name}</th>
            <th scope="col">${texts.errors[error].name}</th>
          </tr>
        </thead>
        <tbody>
          ${[...visible].sort(byCost).map((point) => this.row(point))}
        </tbody>
      </table>
    </details>`;
  }

  private row(point: Point): TemplateResult {
    const details = runDetails(point, this.shown);
    return html`<tr aria-current=${point === this.chosen ? 'true' : 'false'}>
      <th scope="row">
        <button @click=${() => this.choose(point)} @focus=${() => this.choose(point)}>
          ${runName(point.setting, this.shown)}
        </button>
        ${details === '' ? nothing : html`<small>${details}</small>`}
      </th>
      ${amount(costAmount(point, this.shown))} ${amount(errorAmount(point, this.shown))}
    </tr>`;
  }

  private choose(point: Point): void {
    this.dispatchEvent(new CustomEvent('point', { detail: point }));
  }
}
