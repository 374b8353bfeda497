import { LitElement, css, html } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property, query, state } from 'lit/decorators.js';
import { texts } from '../i18n/index.js';
import type { Language } from '../language/language.js';
import type { StripMark } from '../language/texts.js';
import { lanesOf } from './lanes.js';
import type { LaneName } from './lanes.js';
import { lookOf, stripColors } from './look.js';
import { paintSample } from './sample.js';
import type { Sample } from './sample.js';
import { cases } from '../time/course.js';
import type { Header } from '../trace/header.js';
import { base } from '../elements/theme.js';

const legendStyle = css`
  :host {
    position: relative;
  }
  button {
    display: grid;
    place-items: center;
    width: 1.5rem;
    min-height: 1.5rem;
    height: 1.5rem;
    padding: 0;
    border-radius: 50%;
    color: var(--soft);
    font:
      italic 600 0.875rem/1 Georgia,
      'DejaVu Serif',
      serif;
  }
  button[aria-expanded='true'] {
    border-color: var(--accent);
    color: var(--accent);
  }
  section {
    position: absolute;
    right: 0;
    bottom: calc(100% + 0.5rem);
    z-index: 3;
    width: min(27rem, calc(100cqw - 2rem));
    padding: 0.75rem 0.9rem;
    border: 1px solid var(--line);
    border-radius: var(--radius);
    background: var(--panel);
    box-shadow: 0 4px 20px rgb(10 12 18 / 30%);
    font-size: 0.8125rem;
    line-height: 1.35;
  }
  h3 {
    margin-bottom: 0.5rem;
    color: var(--ink);
    font-size: 0.875rem;
  }
  ul {
    display: grid;
    gap: 0.3rem;
    list-style: none;
  }
  li {
    display: grid;
    grid-template-columns: auto minmax(0, 1fr);
    gap: 0.6rem;
    align-items: center;
  }
  li.cases {
    display: block;
  }
  .cases ul {
    display: flex;
    flex-wrap: wrap;
    gap: 0.3rem 0.9rem;
    margin-top: 0.3rem;
  }
  canvas {
    width: 28px;
    height: 14px;
    border-radius: 2px;
    background: var(--well);
  }
  p {
    margin-top: 0.6rem;
    color: var(--soft);
  }
`;

const marks: readonly StripMark[] = ['wrong', 'fault', 'bookmark', 'hit', 'now'];

const width = 28;
const height = 14;

/** The meaning of the strip, in words; opened on demand. */
@customElement('vidno-strip-legend')
export class StripLegendElement extends LitElement {
  static override styles = [base, stripColors, legendStyle];

  @property({ attribute: false }) header!: Header;
  @property({ attribute: false }) language: Language = 'en';
  /** Whether it is unknown which decisions of the run are wrong. */
  @property({ type: Boolean }) unchecked = false;
  @state() private open = false;
  @query('button') private button!: HTMLElement;

  override render(): TemplateResult {
    const { strip } = texts[this.language];
    return html`
      <button
        aria-label=${strip.legend}
        title=${strip.legend}
        aria-expanded=${this.open ? 'true' : 'false'}
        aria-controls="card"
        @click=${() => (this.open = !this.open)}
        @keydown=${this.onKey}
      >
        <span aria-hidden="true">i</span>
      </button>
      <section id="card" aria-label=${strip.legend} ?hidden=${!this.open}>
        <h3>${strip.legend}</h3>
        <ul>
          ${lanesOf(this.header).map(({ name }) => this.lane(name))}
          ${marks.map((name) => this.entry(name, this.explain(name)))}
        </ul>
        <p>${strip.columns}</p>
      </section>
    `;
  }

  private explain(name: StripMark): string {
    const { strip, exact } = texts[this.language];
    const words = strip.explain[name];
    return name === 'wrong' && this.unchecked ? `${words}: ${exact.notChecked}` : words;
  }

  private lane(name: LaneName): TemplateResult {
    const { strip } = texts[this.language];
    if (name !== 'cases') return this.entry(name, strip.explain[name]);
    return html`<li class="cases">
      ${strip.explain.cases}
      <ul>
        ${cases.map((each) => this.entry(each, strip.cases[each]))}
      </ul>
    </li>`;
  }

  private entry(name: Sample, words: string): TemplateResult {
    return html`<li><canvas data-name=${name} aria-hidden="true"></canvas>${words}</li>`;
  }

  private onKey(event: KeyboardEvent): void {
    if (event.key !== 'Escape') return;
    this.open = false;
    this.button.focus();
  }

  /** Paints the samples in the way of the strip. */
  override updated(): void {
    if (!this.open) return;
    const ratio = window.devicePixelRatio;
    const look = lookOf(this, ratio);
    for (const canvas of this.renderRoot.querySelectorAll('canvas')) {
      canvas.width = Math.round(width * ratio);
      canvas.height = Math.round(height * ratio);
      const context = canvas.getContext('2d');
      if (context !== null) paintSample(context, canvas.dataset['name'] as Sample, look);
    }
  }
}
