import { LitElement, css, html, nothing, svg } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property, query } from 'lit/decorators.js';
import { live } from 'lit/directives/live.js';
import type { View } from '../algorithm/view.js';
import { speedsWith } from '../elements/clock.js';
import { base, tallScreen } from '../elements/theme.js';
import { Typed } from '../elements/typed.js';
import type { Check } from '../exactness/truth.js';
import type { Trace } from '../replay/trace.js';
import type { Bookmarks } from '../time/bookmarks.js';
import type { Command } from '../time/travel.js';
import './slider.js';

const transportStyle = css`
  :host {
    display: grid;
    grid-template-columns: auto minmax(0, 1fr) auto auto;
    gap: 0.6rem 1rem;
    align-items: center;
  }
  vidno-slider {
    grid-column: 2 / -1;
  }
  slot {
    display: block;
    grid-column: 1 / 3;
  }
  .buttons {
    display: flex;
    gap: 0.25rem;
  }
  button {
    display: grid;
    place-items: center;
    width: 2.5rem;
    height: 2.5rem;
    padding: 0;
  }
  button[aria-disabled='true'] {
    color: var(--soft);
    opacity: 0.55;
  }
  .play {
    display: flex;
    gap: 0.4rem;
    justify-content: center;
    width: auto;
    min-width: 3.25rem;
    padding: 0 0.5rem;
    border-color: var(--accent);
    background: var(--accent);
    color: var(--on-accent);
  }
  svg {
    width: 1.25rem;
    height: 1.25rem;
    fill: currentColor;
    stroke: currentColor;
    stroke-width: 1.5;
    stroke-linejoin: round;
  }
  label {
    display: flex;
    gap: 0.4rem;
    align-items: center;
    color: var(--soft);
    font-size: 0.8125rem;
    white-space: nowrap;
  }
  input[type='number'] {
    width: 5.75rem;
    height: 2rem;
    contain: strict;
    padding: 0 0.4rem;
    color: var(--ink);
    font-family: var(--mono);
  }
  select {
    padding: 0 0.3rem;
    color: var(--ink);
  }
  .words {
    font-weight: 600;
    white-space: nowrap;
  }
  :host([brief]) {
    grid-template-columns: auto minmax(6rem, 1fr) auto auto;
  }
  :host([brief]) .play {
    padding: 0 0.9rem 0 0.7rem;
  }
  :host([brief]) :is(vidno-slider, slot) {
    grid-column: auto;
  }
  @container (max-width: 920px) {
    :host([brief]) {
      gap: 0.5rem;
    }
    :host([brief]) .step > span:first-child {
      position: absolute;
      clip-path: inset(50%);
    }
  }
  .short {
    display: none;
  }
  @container (max-width: 970px) {
    .long {
      display: none;
    }
    .short {
      display: inline;
    }
  }
  @container (max-width: 830px) {
    :host([brief]) .play {
      padding: 0 0.5rem 0 0.3rem;
    }
    :host([brief]) {
      grid-template-columns: auto minmax(3rem, 1fr) auto auto;
    }
  }
  @container (max-width: 620px) {
    :host([brief]) slot {
      display: none;
    }
    @media (min-height: ${tallScreen}) {
      :host([brief]) slot {
        display: var(--more-controls, block);
        grid-area: 2 / 1 / auto / -1;
      }
    }
  }
  @container (max-width: 800px) {
    :host(:not([brief])) {
      grid-template-columns: 1fr auto auto;
      gap: 0.4rem 0.75rem;
    }
    :host(:not([brief])) vidno-slider {
      grid-row: 2;
      grid-column: 1 / -1;
    }
    :host(:not([brief])) slot {
      grid-row: 3;
      grid-column: 1 / -1;
    }
  }
  @container (max-width: 620px) {
    :host {
      gap: 0.4rem 0.5rem;
    }
    .buttons {
      gap: 0.15rem;
    }
    button {
      width: 2rem;
    }
    .play {
      min-width: 2.5rem;
    }
    label > span {
      position: absolute;
      clip-path: inset(50%);
    }
    input[type='number'] {
      width: 4.4rem;
    }
  }
  @container (max-width: 350px) {
    :host([brief]) {
      grid-template-columns: auto minmax(2rem, 1fr) auto auto;
    }
    button {
      width: 1.75rem;
    }
    .play {
      min-width: 2.25rem;
    }
    input[type='number'] {
      width: 3.5rem;
      padding: 0 0.25rem;
    }
    select {
      padding: 0;
    }
  }
`;

const shapes = {
  first: 'M5 4v12M17 4l-9 6 9 6z',
  back: 'M14 4l-9 6 9 6z',
  play: 'M6 3l10 7-10 7z',
  pause: 'M5 4h3v12H5zM12 4h3v12h-3z',
  forward: 'M6 4l9 6-9 6z',
  last: 'M15 4v12M3 4l9 6-9 6z',
} as const;

/** The controls of time. Its slot has those that go farther than a step. */
@customElement('vidno-transport')
export class TransportElement extends LitElement {
  static override styles = [base, transportStyle];

  @property({ attribute: false }) trace!: Trace;
  @property({ attribute: false }) view!: View;
  @property({ attribute: false }) check!: Check;
  @property({ attribute: false }) bookmarks: Bookmarks = [];
  /** The steps that a search has found. */
  @property({ attribute: false }) hits: readonly number[] = [];
  /** The reachable steps. */
  @property({ attribute: false }) first = 0;
  @property({ attribute: false }) last = 0;
  /** Whether some steps cannot be reached. The strip, which shows the whole run, would then be misleading. */
  @property({ type: Boolean }) bounded = false;
  /** Without the strip and the choice of speed. */
  @property({ type: Boolean }) plain = false;
  /** Only the most common controls, in one row. */
  @property({ type: Boolean, reflect: true }) brief = false;
  /** Whether everything after the step is hidden. */
  @property({ type: Boolean }) veiled = false;
  @property({ type: Boolean }) playing = false;
  @property({ type: Number }) speed = 5;

  @query('.play') private play!: HTMLElement;
  private readonly typed = new Typed(this);

  focusPlay(): void {
    this.play.focus();
  }

  override render(): TemplateResult {
    const { first, last } = this;
    const { step, texts } = this.view;
    return html`
      <div class="buttons">
        ${this.playButton()} ${this.brief ? nothing : this.button('first', first, step === first)}
        ${this.button('back', step - 1, step === first)}
        ${this.button('forward', step + 1, step === last)}
        ${this.brief ? nothing : this.button('last', last, step === last)}
      </div>
      <vidno-slider
        .trace=${this.trace}
        .view=${this.view}
        .check=${this.check}
        .bookmarks=${this.bookmarks}
        .hits=${this.hits}
        .first=${first}
        .last=${last}
        ?plain=${this.plain || this.bounded || this.brief}
        ?veiled=${this.veiled}
        @command=${({ detail }: CustomEvent<Command>) => this.ask(detail)}
      ></vidno-slider>
      <slot></slot>
      <label class="step">
        <span>${texts.step}</span>
        <input
          type="number"
          min=${first}
          max=${last}
          .value=${live(this.typed.or(String(step)))}
          @input=${this.typed.onInput}
          @change=${this.onEnter}
          @blur=${this.typed.onEnd}
        />
        <span class="number">${texts.ofSteps(String(last))}</span>
      </label>
      ${this.plain || this.brief ? nothing : this.speedChoice()}
    `;
  }

  /** At the end it starts over. */
  private playButton(): TemplateResult {
    const { texts, step } = this.view;
    const again = step === this.last ? texts.playAgain : texts.play;
    const label = this.playing ? texts.pause : this.brief ? again : texts.play;
    return html`<button
      class="play"
      aria-label=${label}
      title=${label}
      @click=${() => this.ask({ do: 'play' })}
    >
      ${icon(this.playing ? 'pause' : 'play')} ${this.brief ? this.playWords(label) : nothing}
    </button>`;
  }

  private playWords(label: string): TemplateResult {
    const { play, pause } = this.view.texts;
    return html`<span class="words long">${label}</span>
      <span class="words short">${this.playing ? pause : play}</span>`;
  }

  private speedChoice(): TemplateResult {
    const { texts } = this.view;
    return html`<label class="speed">
      <span>${texts.speed}</span>
      <select @change=${this.onSpeed} title=${texts.perSecond(this.speed)}>
        ${speedsWith(this.speed).map(
          (n) => html`<option value=${n} ?selected=${n === this.speed}>${texts.rate(n)}</option>`,
        )}
      </select>
    </label>`;
  }

  private button(
    name: 'first' | 'back' | 'forward' | 'last',
    to: number,
    off: boolean,
  ): TemplateResult {
    const label = this.view.texts[name];
    return html`<button
      aria-label=${label}
      title=${label}
      aria-disabled=${off ? 'true' : 'false'}
      @click=${() => this.ask({ do: 'seek', step: to })}
    >
      ${icon(name)}
    </button>`;
  }

  private onEnter(event: Event): void {
    const { value } = event.target as HTMLInputElement;
    this.typed.onEnd();
    if (value !== '') this.ask({ do: 'seek', step: Number(value) });
  }

  private onSpeed(event: Event): void {
    this.ask({ do: 'speed', speed: Number((event.target as HTMLSelectElement).value) });
  }

  private ask(command: Command): void {
    this.dispatchEvent(new CustomEvent<Command>('command', { detail: command }));
  }
}

function icon(name: keyof typeof shapes): TemplateResult {
  const path = svg`<path d=${shapes[name]} />`;
  return html`<svg viewBox="0 0 20 20" aria-hidden="true">${path}</svg>`;
}
