import { LitElement, css, html, nothing, svg } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { base } from '../../components/theme.js';
import { isVariant, printed, shape } from '../series.js';
import type { Series, Shape } from '../series.js';
import type { Shown } from '../shown.js';
import { methods } from '../format.js';
import { symbol } from './symbol.js';

/** What the symbols mean; each may be hidden. */
@customElement('vidno-series')
export class SeriesElement extends LitElement {
  static override styles = [
    base,
    css`
      fieldset {
        min-width: 0;
        margin: 0;
        padding: 0;
        border: 0;
      }
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
      ${methods.map((method) => {
        const own = series.filter((each) => each.method === method);
        return own.length === 0 || isVariant(method)
          ? nothing
          : this.method(texts.methods[method], own);
      })}
      ${this.variants()}
      ${
        hasPrinted
          ? this.toggle(printed, texts.printed, 'times', ['currentColor', 'none'])
          : nothing
      }
      <p><svg viewBox="0 0 28 18" aria-hidden="true">${front}</svg>${texts.frontMark}</p>
    </fieldset>`;
  }

  /** Each is a series, by its own name. */
  private variants(): TemplateResult | typeof nothing {
    const { series, texts } = this.shown;
    const own = series.filter(({ method }) => isVariant(method));
    return own.length === 0
      ? nothing
      : html`<div class="variants">${this.method(texts.variants, own)}</div>`;
  }

  private method(name: string, series: readonly Series[]): TemplateResult {
    return html`<fieldset>
      <legend>${name}</legend>
      ${series.map((each) => this.series(each))}
    </fieldset>`;
  }

  private series(series: Series): TemplateResult {
    const color = `var(--${series.id})`;
    const fill = series.method === 'warnock' ? color : 'var(--panel)';
    const { knobs, fixed, variantNames } = this.shown.texts;
    const ofMethod = isVariant(series.method) ? variantNames[series.method] : fixed;
    const name = series.knob === null ? ofMethod : knobs[series.knob];
    return this.toggle(series.id, name, shape(series), [color, fill], series.knob !== null);
  }

  private toggle(
    id: string,
    name: string,
    form: Shape,
    [color, fill]: readonly [string, string],
    hasLine = true,
  ): TemplateResult {
    return html`<label>
      <input
        type="checkbox"
        name=${id}
        .checked=${!this.shown.hidden.has(id)}
        @change=${() => this.flip(id)}
      />
      <svg viewBox="0 0 28 18" aria-hidden="true">${symbol(form, color, fill, hasLine)}</svg>
      <span>${name}</span>
    </label>`;
  }

  private flip(id: string): void {
    const hidden = new Set(this.shown.hidden);
    if (!hidden.delete(id)) hidden.add(id);
    this.dispatchEvent(new CustomEvent('choose', { detail: { hidden } }));
  }
}
