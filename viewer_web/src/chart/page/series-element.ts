import { LitElement, css, html, nothing, svg } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { base } from '../../elements/theme.js';
import { groups, isKernel, isVariant, lookOf, printed } from '../series.js';
import type { Look, Series } from '../series.js';
import type { Shown } from '../shown.js';
import { symbol } from './symbol.js';

/** The symbol of runs of the printed edition, in all series. */
const ofPrinted: Look = { color: 'currentColor', shape: 'times', isFilled: false, scale: 1 };

/** The legend of the series, each with a toggle. */
@customElement('vidno-series')
export class SeriesElement extends LitElement {
  static override styles = [
    base,
    css`
      .all {
        display: grid;
        grid-template-columns: repeat(2, minmax(0, 1fr));
        gap: 0 0.5em;
        align-items: start;
      }
      .variants {
        grid-column: 1 / -1;
      }
      .variants fieldset {
        display: grid;
        grid-template-columns: repeat(2, minmax(0, 1fr));
        gap: 0 0.5em;
      }
      .variants label {
        line-height: 1.15;
      }
      legend {
        padding: 0 0 0.2em;
        font-weight: 600;
      }
      .all > legend {
        font-size: 0.8125em;
        color: var(--soft);
      }
      label,
      p {
        display: flex;
        gap: 0.4em;
        align-items: center;
        min-height: 2em;
        font-size: 0.9375em;
      }
      label {
        cursor: pointer;
      }
      input {
        flex: none;
        width: 1.15em;
        height: 1.15em;
        margin: 0;
        accent-color: var(--accent);
      }
      svg {
        flex: none;
        width: 2em;
        height: 1.3em;
        overflow: visible;
      }
      p {
        padding-left: 1.6em;
      }
      .front {
        fill: none;
        stroke: var(--front);
        stroke-width: 2.5;
      }
    `,
  ];

  @property({ attribute: false }) shown!: Shown;

  override render(): TemplateResult {
    const { series, hasPrinted, texts } = this.shown;
    const front = svg`<path class="front" d="M1 2V9H8M20 9H27M8 9a6 6 0 1 0 12 0a6 6 0 1 0 -12 0" />`;
    return html`<fieldset class="all">
      <legend>${texts.series}</legend>
      ${groups.map((group) => {
        const own = series.filter((each) => each.group === group);
        return own.length === 0 || isVariant(group)
          ? nothing
          : this.group(isKernel(group) ? group : texts.methods[group], own);
      })}
      ${this.variants()} ${hasPrinted ? this.toggle(printed, texts.printed, ofPrinted) : nothing}
      <p><svg viewBox="0 0 28 18" aria-hidden="true">${front}</svg>${texts.frontMark}</p>
    </fieldset>`;
  }

  /** Each variant is a series of its own. */
  private variants(): TemplateResult | typeof nothing {
    const { series, texts } = this.shown;
    const own = series.filter(({ group }) => isVariant(group));
    return own.length === 0
      ? nothing
      : html`<div class="variants">${this.group(texts.variants, own)}</div>`;
  }

  private group(name: string, series: readonly Series[]): TemplateResult {
    return html`<fieldset>
      <legend>${name}</legend>
      ${series.map((each) => this.series(each))}
    </fieldset>`;
  }

  private series(series: Series): TemplateResult {
    const { texts, subjectTexts } = this.shown;
    const { group, knob } = series;
    const untouched = isVariant(group) ? texts.variantNames[group] : subjectTexts.fixed;
    const name = knob === null ? untouched : texts.knobs[knob];
    return this.toggle(series.id, name, lookOf(series), knob !== null);
  }

  private toggle(id: string, name: string, look: Look, hasLine = true): TemplateResult {
    return html`<label>
      <input
        type="checkbox"
        name=${id}
        .checked=${!this.shown.hidden.has(id)}
        @change=${() => this.flip(id)}
      />
      <svg viewBox="0 0 28 18" aria-hidden="true">${symbol(look, hasLine)}</svg>
      <span>${name}</span>
    </label>`;
  }

  private flip(id: string): void {
    const hidden = new Set(this.shown.hidden);
    if (!hidden.delete(id)) hidden.add(id);
    this.dispatchEvent(new CustomEvent('choose', { detail: { hidden } }));
  }
}
