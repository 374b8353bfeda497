import { LitElement, css, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property, query } from 'lit/decorators.js';
import { live } from 'lit/directives/live.js';
import { statement } from '../elements/statement.js';
import { texts } from '../i18n/index.js';
import type { Editing } from '../editor/editor.js';
import type { Exact, Layer } from '../picture/layers.js';
import type { Pixel } from '../picture/pixel.js';
import type { Trace } from '../replay/trace.js';
import type { View } from '../algorithm/view.js';
import { editionName } from '../language/family.js';
import '../listing/listing-element.js';
import type { ListingElement } from '../listing/listing-element.js';
import '../player/picture-panel.js';
import type { PicturePanelElement } from '../player/picture-panel.js';
import type { Kind } from '../picture/save.js';
import { base, hiddenStyle } from '../elements/theme.js';
import { Typed } from '../elements/typed.js';

/** Its parts are items of the surrounding grid. */
const comparedStyle = css`
  :host {
    display: contents;
  }
  .name {
    grid-area: name-one;
    display: flex;
    flex-wrap: wrap;
    gap: 0 0.75rem;
    align-items: center;
    align-content: end;
    min-height: 2rem;
    padding-inline: var(--name-inset, 0px);
  }
  .listing {
    grid-area: list-one;
  }
  .picture {
    grid-area: picture-one;
  }
  .sentence {
    grid-area: said-one;
  }
  :host(.other) .name {
    grid-area: name-other;
  }
  :host(.other) .listing {
    grid-area: list-other;
  }
  :host(.other) .picture {
    grid-area: picture-other;
  }
  :host(.other) .sentence {
    grid-area: said-other;
  }
  section {
    display: flex;
    min-width: 0;
    min-height: 0;
    overflow: hidden;
    border: 1px solid var(--line);
    border-radius: var(--radius);
    background: var(--panel);
  }
  section > * {
    flex: 1;
    min-width: 0;
  }
  .listing {
    display: var(--listing, flex);
    contain: size;
  }
  /* Where there is little room, the step has a line of its own, because its number may grow. */
  h3 {
    flex: 0 1 var(--name-width, auto);
    color: var(--ink);
    font-size: var(--name-size, 0.9375rem);
    letter-spacing: 0;
  }
  .note,
  .step {
    color: var(--soft);
    font-size: 0.8125rem;
  }
  .step {
    display: flex;
    gap: 0.25rem;
    margin-left: auto;
  }
  button {
    width: 2rem;
    padding: 0;
  }
  button[aria-disabled='true'] {
    color: var(--soft);
    opacity: 0.55;
  }
  input {
    width: 5rem;
    padding: 0 0.3rem;
    color: var(--ink);
    font-family: var(--mono);
  }
  .sentence {
    display: flex;
    gap: 0.6rem;
    align-items: center;
    height: var(--said, 3.1rem);
    padding: 0 0.6rem;
    overflow: hidden;
    border: 1px solid var(--line);
    border-radius: var(--radius);
    background: var(--panel);
    font-size: var(--said-size, 1rem);
    line-height: 1.35;
  }
  .sentence .at {
    flex: none;
    min-width: 3rem;
    padding: 0.1rem 0.3rem;
    border-radius: 5px;
    background: var(--now);
    font: 600 0.875rem / 1.5 var(--mono);
    text-align: center;
  }
  @media print {
    .listing {
      zoom: 0.7;
    }
  }
`;

/**
 * One of two compared runs; its parts lie in the grid of both. An event `pixel` carries a chosen pixel, an event `step` a
 * step to which this run alone shall go.
 */
@customElement('vidno-compared-run')
export class ComparedRunElement extends LitElement {
  static override styles = [base, hiddenStyle, comparedStyle];

  @property({ attribute: false }) trace!: Trace;
  @property({ attribute: false }) view!: View;
  @property({ attribute: false }) layer: Layer = 'picture';
  /** The picture of the other run. */
  @property({ attribute: false }) against: Exact = null;
  @property({ attribute: false }) editing: Editing | null = null;
  /** A description of the run, if its header does not suffice. */
  @property({ attribute: false }) note = '';
  /** Whether this run is stepped by itself. */
  @property({ type: Boolean }) alone = false;
  @property({ type: Boolean }) playing = false;
  /** Whether its lines can be broken. */
  @property({ type: Boolean }) breakable = false;

  @query('vidno-picture-panel') private picture!: PicturePanelElement;
  @query('vidno-listing') private listing!: ListingElement;
  private readonly typed = new Typed(this);

  startChoosing(): void {
    this.picture.startChoosing();
  }

  toggleSource(): void {
    this.listing.toggleSource();
  }

  save(kind: Kind): Promise<void> {
    return this.picture.save(kind);
  }

  override render(): TemplateResult {
    const { trace, view } = this;
    const { texts: say, event } = view;
    const name = this.name();
    return html`
      <div class="name">
        <h3>${name}</h3>
        ${this.note === '' ? nothing : html`<p class="note">${this.note}</p>`}
        ${this.alone ? this.steps() : this.step()}
      </div>
      <section class="picture" aria-label="${say.picture}: ${name}">
        <vidno-picture-panel
          .view=${view}
          .editing=${this.editing}
          .layer=${this.layer}
          .exact=${this.against}
          @pixel=${({ detail }: CustomEvent<Pixel>) => this.tell('pixel', detail)}
        ></vidno-picture-panel>
      </section>
      <section class="listing" aria-label="${say.listing}: ${name}">
        <vidno-listing .trace=${trace} .view=${view} ?breakable=${this.breakable}></vidno-listing>
      </section>
      <p class="sentence" aria-live=${this.playing ? 'off' : 'polite'} aria-atomic="true">
        <span class="at">${event?.at ?? '·'}</span>
        <span class="heard">: </span>
        <span>${statement(view.sentence)}</span>
      </p>
    `;
  }

  private name(): string {
    const { texts: say, header } = this.view;
    const { method, edition, kernel } = header;
    return [say.methods[method], editionName(say.editions, edition), kernel].join(' · ');
  }

  private step(): TemplateResult {
    const { step, length, language } = this.view;
    const [now, all] = [step, length].map((n) => n.toLocaleString(language));
    return html`<p class="step">${texts[language].compare.step(now ?? '', all ?? '')}</p>`;
  }

  private steps(): TemplateResult {
    const { step, length, language } = this.view;
    const { compare: say } = texts[language];
    return html`<p class="step">
      ${this.button('‹', say.back, step - 1)}
      <input
        type="number"
        min="0"
        max=${length}
        aria-label=${say.otherStep}
        .value=${live(this.typed.or(String(step)))}
        @input=${this.typed.onInput}
        @change=${this.onEnter}
        @blur=${this.typed.onEnd}
      />
      ${this.button('›', say.forward, step + 1)}
    </p>`;
  }

  private onEnter({ target }: Event): void {
    const { value } = target as HTMLInputElement;
    this.typed.onEnd();
    this.tell('step', Number(value));
  }

  private button(shown: string, label: string, step: number): TemplateResult {
    return html`<button
      aria-label=${label}
      title=${label}
      aria-disabled=${step < 0 || step > this.view.length ? 'true' : 'false'}
      @click=${() => this.tell('step', step)}
    >
      ${shown}
    </button>`;
  }

  private tell(what: 'pixel' | 'step', detail: Pixel | number): void {
    this.dispatchEvent(new CustomEvent(what, { detail }));
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'vidno-compared-run': ComparedRunElement;
  }
}
