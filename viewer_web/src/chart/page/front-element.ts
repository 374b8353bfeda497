import { LitElement, css, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { base } from '../../elements/theme.js';
import type { Point } from '../points.js';
import type { Shown } from '../shown.js';
import { costAmount, errorAmount, runDetails, runName } from '../words.js';
import type { Amount } from '../words.js';

/** The runs on the front as a table, the text alternative of the plot. */
@customElement('vidno-front')
export class FrontElement extends LitElement {
  static override styles = [
    base,
    css`
      :host {
        display: block;
      }
      table {
        width: 100%;
      }
      caption {
        padding-bottom: 0.35rem;
        text-align: left;
        font-size: 0.8125em;
        font-weight: 600;
        color: var(--soft);
      }
      th,
      td {
        padding: 0.3em 0.6em 0.3em 0;
        border-top: 1px solid var(--line);
        text-align: left;
        font-weight: 400;
        vertical-align: top;
      }
      thead th {
        font-size: 0.8125em;
        color: var(--soft);
      }
      td.number {
        font-size: 0.9375em;
        white-space: nowrap;
      }
      small {
        display: block;
        font-size: 0.8125em;
        color: var(--soft);
      }
      [aria-current='true'] small {
        color: var(--ink);
      }
      button {
        min-height: 1.6em;
        padding: 0;
        border: 0;
        background: none;
        text-align: left;
        text-decoration: underline dotted var(--soft);
        text-underline-offset: 0.25em;
      }
      tr[aria-current='true'] > * {
        background: var(--now);
      }
    `,
  ];

  @property({ attribute: false }) shown!: Shown;
  @property({ attribute: false }) chosen: Point | null = null;

  override render(): TemplateResult {
    const { texts, front, cost, error } = this.shown;
    return html`<table>
      <caption>
        ${texts.front}
      </caption>
      <thead>
        <tr>
          <th scope="col">${texts.run}</th>
          <th scope="col">${texts.costs[cost].name}</th>
          <th scope="col">${texts.errors[error].name}</th>
        </tr>
      </thead>
      <tbody>
        ${front.map((point) => this.row(point))}
      </tbody>
    </table>`;
  }

  private row(point: Point): TemplateResult {
    const { setting } = point;
    return html`<tr aria-current=${point === this.chosen ? 'true' : 'false'}>
      <th scope="row">
        <button @click=${() => this.choose(point)} @focus=${() => this.choose(point)}>
          ${runName(setting, this.shown)}
        </button>
        <small>${runDetails(point, this.shown)}</small>
      </th>
      ${amount(costAmount(point, this.shown))} ${amount(errorAmount(point, this.shown))}
    </tr>`;
  }

  private choose(point: Point): void {
    this.dispatchEvent(new CustomEvent('point', { detail: point }));
  }
}

function amount([shown, counted]: Amount): TemplateResult {
  return html`<td class="number">
    ${shown}${counted === null ? nothing : html`<small>${counted}</small>`}
  </td>`;
}
