import { LitElement, css, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property, state } from 'lit/decorators.js';
import { numbersOf } from '../algorithm/view.js';
import type { View } from '../algorithm/view.js';
import { panelsStyle } from '../elements/panels.style.js';
import { base } from '../elements/theme.js';
import { texts } from '../i18n/index.js';
import { superscript } from '../language/words.js';
import type { ExactTexts } from '../language/texts.js';
import { isSeen, narrow, orders, sortedBy } from './finding.js';
import type { Finding, Order } from './finding.js';
import type { N } from '../trace/values.js';

/** The number of rows shown until the reader asks for more. */
const page = 60;

/** The most characters of a number. */
const longest = 60;

/** The decisions of the run that are worth looking at, in a chosen order, each with a link to its step. */
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
      .hint {
        color: var(--soft);
        font-size: 0.75rem;
      }
      .legend {
        display: flex;
        flex-wrap: wrap;
        gap: 0.2rem 0.9rem;
        margin: 0 0 0.3rem;
        padding: 0;
        list-style: none;
        font-size: 0.75rem;
      }
      .sample {
        display: inline-block;
        width: 0.8em;
        height: 0.8em;
        border: 2px solid #c1121f;
        vertical-align: -0.1em;
        forced-color-adjust: none;
      }
      .sample.zero {
        border: 1px solid #0b7a4b;
      }
      .sample.narrow {
        border: 1px dotted #b25e00;
      }
      table {
        width: 100%;
        font-size: 0.75rem;
      }
      th,
      td {
        padding: 0.15rem 0.4rem 0.15rem 0;
        text-align: left;
        vertical-align: baseline;
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
        white-space: nowrap;
      }
      .detail td {
        padding: 0.1rem 0.4rem 0.4rem 1rem;
        color: var(--soft);
        overflow-wrap: anywhere;
      }
      tr:is([aria-current], .detail) td {
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
  @state() private order: Order = 'kind';
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
      ${rows.some(({ isShown }) => isShown === false) ? html`<p class="hint">${say.within}</p>` : nothing}
      ${rows.some(({ kind }) => kind !== 'point') ? this.legend(rows) : nothing}
      ${rows.length === 0 ? nothing : this.table(rows)}
    </section>`;
  }

  /** What the colours in the picture and on the strip mean. */
  private legend(rows: readonly Finding[]): TemplateResult {
    const { kinds, narrowBy } = this.texts.findings;
    const nameOf = (kind: keyof typeof kinds): string =>
      kind === 'narrow' ? narrowBy(narrow) : kinds[kind];
    const met = (['wrong', 'zero', 'narrow'] as const).filter((kind) =>
      rows.some((row) => row.kind === kind),
    );
    return html`<ul class="legend">
      ${met.map((kind) => html`<li><span class="sample ${kind}"></span> ${nameOf(kind)}</li>`)}
    </ul>`;
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

  private row(finding: Finding): TemplateResult {
    const { step, at, kind, coincidence, ulps, off, polygons, isShown = true } = finding;
    const say = this.texts.findings;
    const what = coincidence === undefined ? '' : say.coincidences[coincidence];
    const isHere = step === this.view.step;
    return html`<tr aria-current=${isHere ? 'step' : nothing}>
        <td class="number">
          <button @click=${() => this.seek(step)}>${step}</button>
          ${isShown ? at : html`<span class="hint">⊃ ${at}</span>`}
        </td>
        <td>${say.kinds[kind]}${what === '' ? '' : ': '}${what}</td>
        <td class="number">
          ${off === undefined ? this.width(ulps) : say.pixels(this.width(off))}
        </td>
        <td>${polygons.join(', ')}</td>
      </tr>
      ${isHere ? this.detail(finding) : nothing}`;
  }

  /** The details of a decision, shown at its step. */
  private detail({ procedure, of, taken, exact, cause, ...numbers }: Finding): TemplateResult {
    const { texts: say } = this;
    const { computed, gap, operands, pixels } = numbers;
    const { windowText } = numbersOf(this.view);
    const right = exact === undefined ? '' : `; ${say.exact.toLowerCase()}: ${say.answer(exact)}`;
    const lines = [
      of === undefined ? procedure : `${procedure}: ${say.decided[of]}`,
      taken === undefined ? '' : `${say.computed}: ${say.answer(taken)}${right}`,
      cause === undefined ? '' : say.causes[cause],
      of === undefined ? operands.map((each) => this.coordinate(each)).join('; ') : '',
      gap === undefined ? '' : say.findings.gap(this.number(computed ?? gap), this.number(gap)),
      say.findings.decides(windowText(pixels)),
    ];
    return html`<tr class="detail">
      <td colspan="4">
        ${lines.filter((line) => line !== '').map((line) => html`<p title=${line}>${line}</p>`)}
      </td>
    </tr>`;
  }

  private coordinate([name, used, exact]: Finding['operands'][number]): string {
    const right = exact === used || exact === null ? '' : ` (${this.number(exact)})`;
    return `${name} = ${this.number(used ?? 'nan')}${right}`;
  }

  /** A shortened number, because fractions may be long; the file has all digits. */
  private number(value: N): string {
    const plain = numbersOf(this.view).whole(value).replace(/\/1$/u, '');
    return plain.length > longest ? `${plain.slice(0, longest)}…` : plain;
  }

  /** A short number, because only its order of magnitude matters. */
  private width(value: number | undefined): string {
    if (value === undefined) return '';
    const { whole } = numbersOf(this.view);
    const [digits = '', power = '0'] = value.toExponential(2).split('e');
    if (Math.abs(Number(power)) <= 5) return whole(Number(value.toPrecision(3)));
    return `${whole(digits)} · 10${superscript(Number(power))}`;
  }

  private seek(step: number): void {
    this.dispatchEvent(
      new CustomEvent('command', { detail: { do: 'seek', step }, bubbles: true, composed: true }),
    );
  }
}
