import { LitElement, css, html, nothing, svg } from 'lit';
import type { SVGTemplateResult, TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { base } from '../../elements/theme.js';
import { groups, isKernel, isVariant, lookOf, printed } from '../series.js';
import type { Look, Series, Shape } from '../series.js';
import type { Shown } from '../shown.js';

/** The symbols of Plot, around 0 0. */
const outlines: Readonly<Record<Shape, string>> = {
  circle: 'M-5 0a5 5 0 1 0 10 0a5 5 0 1 0 -10 0z',
  square: 'M-4.4 -4.4h8.8v8.8h-8.8z',
  triangle: 'M0 -6.7L5.8 3.4H-5.8z',
  diamond2: 'M0 -6.2L6.2 0L0 6.2L-6.2 0z',
  star: 'M0 -7.9L1.8 -2.4H7.5L2.9 .9L4.6 6.4L0 3L-4.6 6.4L-2.9 .9L-7.5 -2.4H-1.8z',
  times: 'M-4.5 -4.5L4.5 4.5M-4.5 4.5L4.5 -4.5',
  plus: 'M-6 0h12M0 -6v12',
  asterisk: 'M0 -6.5v13M-5.6 -3.2L5.6 3.2M-5.6 3.2L5.6 -3.2',
  cross: 'M-6 -2h4v-4h4v4h4v4h-4v4h-4v-4h-4z',
  triangle2: 'M0 6.7L5.8 -3.4H-5.8z',
  wye: 'M-2 6.3V1.2L-6.4 -1.4L-4.4 -4.8L0 -2.3L4.4 -4.8L6.4 -1.4L2 1.2V6.3z',
  hexagon: 'M0 -6L5.2 -3V3L0 6L-5.2 3V-3z',
};

/** A series' symbol, 28 x 18, with a line if a knob is varied, or the text is the printed one. */
function symbol({ color, shape, isFilled, scale }: Look, hasLine: boolean): SVGTemplateResult {
  const dashes = shape === 'times' ? '5 4' : 'none';
  const fill = isFilled ? color : 'var(--panel)';
  return svg`<g transform="translate(14 9)" stroke=${color} stroke-width="2" fill=${fill}>
    ${hasLine ? svg`<path d="M-14 0H14" stroke-dasharray=${dashes} />` : ''}
    <path d=${outlines[shape]} transform="scale(${scale})" stroke-width=${2 / scale} />
  </g>`;
}

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
