import { LitElement, css, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property, state } from 'lit/decorators.js';
import type { Comparison } from './comparison.js';
import { counters } from './counters.js';
import type { Counter, Counts } from './counters.js';
import type { Steps } from './parting.js';
import type { CompareTexts } from '../language/texts.js';
import { texts } from '../i18n/index.js';
import type { Language } from '../language/language.js';
import { isChecked } from '../exactness/certainty.js';
import { textureStyle } from '../picture/picture.style.js';
import { base, hiddenStyle } from '../elements/theme.js';

const factsStyle = css`
  :host {
    position: relative;
    display: block;
    flex: none;
    padding: 0.45rem 0.9rem;
    border: 1px solid var(--line);
    border-radius: var(--radius);
    background: var(--panel);
    font-size: 0.8125rem;
  }
  .row {
    display: flex;
    flex-wrap: wrap;
    gap: 0.3rem 1.5rem;
    align-items: center;
  }
  .row > p {
    display: flex;
    flex-wrap: wrap;
    gap: 0.3rem 0.6rem;
    align-items: center;
    min-height: 2rem;
  }
  .switches {
    margin-left: auto;
  }
  .name,
  dt,
  .who {
    color: var(--soft);
  }
  button {
    padding: 0 0.6rem;
  }
  label {
    display: flex;
    gap: 0.35rem;
    align-items: center;
    min-height: 1.5rem;
    white-space: nowrap;
  }
  input {
    width: 1.05rem;
    height: 1.05rem;
    margin: 0;
    accent-color: var(--accent);
  }
  dl {
    display: grid;
    grid-template-columns: repeat(auto-fit, minmax(8.4rem, 1fr));
    gap: 0.3rem 0.75rem;
    margin-top: 0.3rem;
    padding-top: 0.35rem;
    border-top: 1px solid var(--line);
  }
  .fold {
    display: none;
  }
  .fold::before {
    content: '▸ ';
  }
  .fold[aria-expanded='true']::before {
    content: '▾ ';
  }
  dt,
  .who {
    font-size: 0.75rem;
    line-height: 1.5;
  }
  dt,
  dd {
    white-space: nowrap;
    line-height: 1.5;
  }
  dd small {
    color: var(--soft);
    font-size: 0.75rem;
  }
  label:not(:first-child) {
    margin-left: 0.5rem;
  }
  /* Numbers may grow from step to step; nothing else must move. */
  @container (max-width: 1100px) {
    .row > p {
      flex-basis: 100%;
      margin-left: 0;
    }
  }
  @container (max-width: 620px) {
    label:not(:first-child) {
      margin-left: 0;
    }
    .fold {
      display: block;
      margin-top: 0.3rem;
    }
    .fold:not([aria-expanded='true']) + dl {
      display: none;
    }
  }
  @media print {
    .row > .switches {
      display: none;
    }
    button {
      padding: 0;
      border: 0;
    }
  }
`;

/** The switches of a comparison. */
export type Switch = 'together' | 'mark' | 'edit';

/**
 * Where two runs diverge, how many pixels differ, and the counters. An event `go` asks for a step of the first run, an
 * event `switch` to turn one of the switches.
 */
@customElement('vidno-comparison-facts')
export class ComparisonFactsElement extends LitElement {
  static override styles = [base, hiddenStyle, textureStyle, factsStyle];

  @property({ attribute: false }) comparison!: Comparison;
  /** The current steps. */
  @property({ attribute: false }) steps!: Steps;
  /** The number of pixels or columns that differ there; null if the pictures have different sizes. */
  @property({ attribute: false }) differs: number | null = null;
  @property({ attribute: false }) on: ReadonlySet<Switch> = new Set();
  @property({ type: Boolean }) editable = false;
  @property({ attribute: false }) language: Language = 'en';
  /** Whether the counters are shown where there is little room. */
  @state() private isUnfolded = false;

  private get say(): CompareTexts {
    return texts[this.language].compare;
  }

  private number(n: number): string {
    return n.toLocaleString(this.language);
  }

  override render(): TemplateResult {
    const { say, comparison } = this;
    const isOfCurves = comparison.one.header.scene.curves !== null;
    return html`
      <div class="row">
        <p class="parting"><span class="name">${say.parting}</span>${this.parting()}</p>
        <p class="differ">
          <span class="name">${isOfCurves ? say.differColumns : say.differ}</span
          >${this.difference()}
        </p>
        <p class="switches">
          ${this.switch('mark', say.mark, 'L')}
          <span role="img" aria-label=${say.otherColor} title=${say.otherColor}
            ><i class="wrong"></i
          ></span>
          <span role="img" aria-label=${say.unpainted} title=${say.unpainted}
            ><i class="lacking"></i
          ></span>
          ${this.switch('together', say.together, say.togetherHint)}
          ${this.editable ? this.switch('edit', say.edit, `${say.editHint} (E)`) : nothing}
        </p>
      </div>
      ${comparison.alignment === null ? nothing : html`<p class="share">${say[comparison.alignment]}</p>`}
      ${this.counters()}
    `;
  }

  private parting(): TemplateResult {
    const { say } = this;
    const { parting } = this.comparison;
    if (parting === null) return html`<span>${say.otherMethods}</span>`;
    return html`${(['text', 'deed'] as const).map((kind) => {
      const found = parting[kind];
      const missing = parting.complete ? say.nowhere : say.searching;
      return html`<span class=${kind}
        >${say[kind]}${found === null ? html` ${missing}` : html` ${this.goTo(found[0])}`}</span
      >`;
    })}`;
  }

  private goTo(step: number): TemplateResult {
    return html`<button
      @click=${() => this.dispatchEvent(new CustomEvent<number>('go', { detail: step }))}
    >
      ${this.say.atStep(this.number(step))}
    </button>`;
  }

  private difference(): TemplateResult {
    const { say, differs } = this;
    const { differsAtEnd } = this.comparison;
    if (differs === null) return html`<span>${say.otherArea}</span>`;
    const atEnd = differsAtEnd === null ? '' : `, ${say.differAtEnd(this.number(differsAtEnd))}`;
    return html`<span>${say.differNow(this.number(differs))}${atEnd}</span>`;
  }

  private switch(name: Switch, label: string, hint: string): TemplateResult {
    return html`<label title=${hint}>
      <input
        type="checkbox"
        name=${name}
        .checked=${this.on.has(name)}
        @change=${() => this.dispatchEvent(new CustomEvent<Switch>('switch', { detail: name }))}
      />${label}
    </label>`;
  }

  /** The counters, without those that neither run has. */
  private counters(): TemplateResult {
    const { say, comparison } = this;
    const now = comparison.counts(this.steps);
    const all = comparison.counts();
    const areChecked = [comparison.one, comparison.other].some(isChecked);
    const shown = counters.filter((each) =>
      each === 'wrong' ? areChecked : all.some((counts) => counts[each] !== null),
    );
    return html`<button
        class="fold"
        aria-expanded=${this.isUnfolded ? 'true' : 'false'}
        @click=${() => (this.isUnfolded = !this.isUnfolded)}
      >
        ${say.counters}
      </button>
      <dl aria-label=${say.counters}>
        <div aria-hidden="true" class="who">
          <p>${say.soFar} / ${say.inAll}</p>
          <p>${say.thisRun}</p>
          <p>${say.otherRun}</p>
        </div>
        ${shown.map(
          (each) =>
            html`<div class=${each}>
              <dt>${say.counts[each]}</dt>
              <dd>${this.count(say.thisRun, each, now[0], all[0])}</dd>
              <dd>${this.count(say.otherRun, each, now[1], all[1])}</dd>
            </div>`,
        )}
      </dl>`;
  }

  private count(whose: string, counter: Counter, now: Counts, all: Counts): TemplateResult {
    const [sofar, total] = [now[counter], all[counter]];
    if (sofar === null || total === null) {
      const missing = counter === 'wrong' ? texts[this.language].exact.notChecked : '—';
      return html`<span class="heard">${whose}:</span>${missing}`;
    }
    return html`<span class="heard">${whose}:</span
      ><span class="number">${this.number(sofar)}<small> / ${this.number(total)}</small></span>`;
  }
}
