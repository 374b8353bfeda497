import { LitElement, css, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property, state } from 'lit/decorators.js';
import type { View } from '../algorithm/view.js';
import { panelsStyle } from '../elements/panels.style.js';
import { base } from '../elements/theme.js';
import { texts } from '../i18n/index.js';
import type { ExactTexts } from '../language/exact-texts.js';
import { isSeen, orders, sortedBy } from './finding.js';
import type { Finding, Order } from './finding.js';

/** Rows that are shown before one asks for more. */
const page = 60;

/** The decisions of the run that are worth looking at, to be sorted; each leads to its step. */
@customElement('vidno-findings')
export class FindingsElement extends LitElement {
  static override styles = [
    base,
    panelsStyle,
    css`
      .bar {
        display: flex;
        flex-wrap: wrap;
        gap: 0.4rem 0.8rem;
        align-items: center;
        margin-bottom: 0.3rem;
        font-size: 0.8125rem;
      }
      table {
        width: 100%;
        border-collapse: collapse;
        font-size: 0.75rem;
      }
      th,
      td {
        padding: 0.15rem 0.4rem 0.15rem 0;
        text-align: left;
        vertical-align: top;
      }
      th button {
        padding: 0;
        border: 0;
        background: none;
        font-weight: 600;
      }
      td.number {
        text-align: right;
        font-variant-numeric: tabular-nums;
      }
      tr[aria-current] td {
        background: var(--chosen, color-mix(in srgb, var(--accent) 14%, transparent));
      }
      td button {
        padding: 0 0.2rem;
        border: 0;
        background: none;
        color: var(--accent);
        text-decoration: underline;
      }
    `,
  ];

  @property({ attribute: false }) view!: View;
  @property({ attribute: false }) findings: readonly Finding[] = [];
  @state() private order: Order = 'step';
  @state() private withNumbers = false;
  @state() private shown = page;

  private get texts(): ExactTexts {
    return texts[this.view.language].exact;
  }

  override render(): TemplateResult {
    const say = this.texts.findings;
    const all = this.findings;
    const seen = this.withNumbers ? all : all.filter(isSeen);
    const rows = sortedBy(this.order, seen);
    return html`<section aria-label=${say.title}>
      <h3>${say.title}</h3>
      <div class="bar">
        <span role="status">${say.count(seen.length)}</span>
        ${
          all.some((each) => !isSeen(each))
            ? html`<label>
                <input
                  type="checkbox"
                  .checked=${this.withNumbers}
                  @change=${() => (this.withNumbers = !this.withNumbers)}
                />
                ${say.withNumbers}
              </label>`
            : nothing
        }
      </div>
      ${rows.length === 0 ? nothing : this.table(rows)}
    </section>`;
  }

  private table(rows: readonly Finding[]): TemplateResult {
    const say = this.texts.findings;
    return html`<table>
        <thead>
          <tr>
            ${orders.map(
              (order) =>
                html`<th scope="col" aria-sort=${order === this.order ? 'ascending' : 'none'}>
                  <button @click=${() => (this.order = order)}>
                    ${say.columns[order]}${order === this.order ? ' ▲' : ''}
                  </button>
                </th>`,
            )}
            <th scope="col">${say.polygons}</th>
          </tr>
        </thead>
        <tbody>
          ${rows.slice(0, this.shown).map((row) => this.row(row))}
        </tbody>
      </table>
      ${
        rows.length > this.shown
          ? html`<button @click=${() => (this.shown += page)}>${say.more}</button>`
          : nothing
      }`;
  }

  private row({ step, at, kind, coincidence, ulps, off, polygons }: Finding): TemplateResult {
    const say = this.texts.findings;
    const what = coincidence === undefined ? '' : say.coincidences[coincidence];
    return html`<tr aria-current=${step === this.view.step ? 'step' : nothing}>
      <td class="number"><button @click=${() => this.seek(step)}>${step}</button> ${at}</td>
      <td>${say.kinds[kind]}${what === '' ? '' : ': '}${what}</td>
      <td class="number">${off === undefined ? width(ulps) : say.pixels(width(off))}</td>
      <td>${polygons.join(', ')}</td>
    </tr>`;
  }

  private seek(step: number): void {
    this.dispatchEvent(
      new CustomEvent('command', { detail: { do: 'seek', step }, bubbles: true, composed: true }),
    );
  }
}

/** Short: what counts is how small it is. */
function width(value: number | undefined): string {
  if (value === undefined) return '';
  const [digits = '', power] = value.toExponential(2).split('e');
  if (Math.abs(Number(power)) > 5) return `${digits} · 10^${power?.replace('+', '') ?? ''}`;
  return String(Number(value.toPrecision(3)));
}

declare global {
  interface HTMLElementTagNameMap {
    'vidno-findings': FindingsElement;
  }
}
