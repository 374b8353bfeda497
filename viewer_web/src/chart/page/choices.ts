import { LitElement, css, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { base } from '../../elements/theme.js';
import { front, groups, isKernel, isVariant, printed } from '../series.js';
import type { Series } from '../series.js';
import type { Shown } from '../shown.js';
import { selectStyle } from './select.style.js';

/** The choice of the two axes, and of a series beside the main points. */
@customElement('vidno-choices')
export class ChoicesElement extends LitElement {
  static override styles = [
    base,
    selectStyle,
    css`
      :host {
        display: flex;
        flex-wrap: wrap;
        gap: 0.5rem 1.25rem;
        align-items: center;
      }
      fieldset {
        display: flex;
        gap: 0.5rem;
        align-items: center;
        min-width: 0;
      }
      legend {
        float: left;
        color: var(--soft);
      }
      select {
        max-width: 13rem;
      }
      .segments {
        display: flex;
        flex-wrap: wrap;
        gap: 1px;
        overflow: hidden;
        border: 1px solid var(--line);
        border-radius: 6px;
        background: var(--line);
      }
      .segments:has(:focus-visible) {
        outline: 3px solid var(--accent);
        outline-offset: 2px;
      }
      .segments label {
        position: relative;
        flex: auto;
        padding: 0.25rem 0.7rem;
        background: var(--panel);
        text-align: center;
        white-space: nowrap;
      }
      .segments label:has(:checked) {
        background: var(--accent);
        color: var(--on-accent);
      }
      @media (forced-colors: active) {
        .segments label:has(:checked) {
          forced-color-adjust: none;
          background: Highlight;
          color: HighlightText;
        }
      }
      .segments input {
        position: absolute;
        inset: 0;
        width: 100%;
        height: 100%;
        margin: 0;
        opacity: 0;
        cursor: pointer;
      }
      @media (max-width: 640px) {
        .choice,
        fieldset {
          display: block;
          flex: 1 1 100%;
        }
        .choice > span,
        legend {
          float: none;
          font-size: 0.8125em;
        }
        select {
          width: 100%;
          max-width: none;
        }
      }
    `,
  ];

  @property({ attribute: false }) shown!: Shown;

  override render(): TemplateResult {
    const { texts, axes, cost, error } = this.shown;
    const costTexts = axes.costs.map((id) => [id, texts.costs[id].name] as const);
    const errorTexts = axes.errors.map((id) => [id, texts.errors[id].name] as const);
    return html`
      ${this.segments('cost', texts.cost, costTexts, cost)}
      ${this.segments('error', texts.error, errorTexts, error)} ${this.adding()}
    `;
  }

  /** The series beside the main points: one at a time. */
  private adding(): TemplateResult {
    const { texts, series, hasPrinted } = this.shown;
    const kinds = groups.filter((group) => !isVariant(group));
    const variants = series.filter(({ group }) => isVariant(group));
    return html`<label class="choice">
      <span>${texts.add}</span>
      <select name="series" @change=${this.onSeries}>
        ${this.seriesOption('', texts.nothingMore)} ${this.seriesOption(front, texts.front)}
        ${hasPrinted ? this.seriesOption(printed, texts.printed) : nothing}
        ${kinds.map((group) =>
          this.seriesGroup(
            isKernel(group) ? group : texts.methods[group],
            series.filter((each) => each.group === group),
          ),
        )}
        ${this.seriesGroup(texts.variants, variants)}
      </select>
    </label>`;
  }

  private seriesGroup(name: string, series: readonly Series[]): TemplateResult | typeof nothing {
    if (series.length === 0) return nothing;
    return html`<optgroup label=${name}>
      ${series.map((each) => this.seriesOption(each.id, this.seriesName(each)))}
    </optgroup>`;
  }

  private seriesName({ group, knob }: Series): string {
    const { texts, subjectTexts } = this.shown;
    if (knob !== null) return texts.knobs[knob];
    return isVariant(group) ? texts.variantNames[group] : subjectTexts.fixed;
  }

  private seriesOption(id: string, name: string): TemplateResult {
    return html`<option value=${id} .selected=${id === (this.shown.chosenSeries ?? '')}>
      ${name}
    </option>`;
  }

  private onSeries(event: Event): void {
    this.choose({ series: (event.target as HTMLSelectElement).value || null });
  }

  private segments(
    name: 'cost' | 'error',
    title: string,
    options: readonly (readonly [string, string])[],
    chosen: string,
  ): TemplateResult {
    return html`<fieldset>
      <legend>${title}</legend>
      <div class="segments">
        ${options.map(
          ([id, label]) =>
            html`<label>
              <input
                type="radio"
                name=${name}
                value=${id}
                .checked=${id === chosen}
                @change=${() => this.choose({ [name]: id })}
              />${label}
            </label>`,
        )}
      </div>
    </fieldset>`;
  }

  private choose(detail: object): void {
    this.dispatchEvent(new CustomEvent('choose', { detail }));
  }
}
