import { LitElement, css, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property, state } from 'lit/decorators.js';
import type { View } from '../algorithm/view.js';
import { download, fileName } from '../base/file.js';
import { liveKey } from '../base/key-map.js';
import { kbd } from '../elements/keyboard.js';
import { base } from '../elements/theme.js';
import { texts } from '../i18n/index.js';
import type { PredictTexts } from '../language/texts.js';
import type { Command } from '../time/travel.js';
import type { Header } from '../trace/header.js';
import { howWell } from './grade.js';
import type { Current, Predictor } from './predictor.js';
import type { Kind } from './question.js';
import './question-element.js';
import type { Answered, Score } from './score.js';

const predictStyle = css`
  :host {
    display: block;
    min-height: 0;
    overflow: auto;
    scroll-padding: 2rem 0 3.5rem;
    scrollbar-width: thin;
    font-size: 0.8125rem;
  }
  section {
    padding: 0.6rem 0.75rem;
  }
  section + section {
    border-top: 1px solid var(--line);
  }
  .hint,
  small {
    color: var(--soft);
  }
  small {
    display: block;
    font-size: 0.92em;
  }
  .next {
    margin-top: 0.5rem;
    padding: 0 0.8rem;
    border-color: var(--accent);
    background: var(--accent);
    color: var(--on-accent);
  }
  kbd {
    font: 0.6875rem var(--mono);
  }
  fieldset {
    margin: 0.4rem 0 0;
  }
  legend {
    font-weight: 600;
  }
  label {
    display: flex;
    gap: 0.45rem;
    align-items: baseline;
    min-height: 1.625rem;
    padding: 0.15rem 0;
    cursor: pointer;
  }
  label input {
    flex: none;
    width: 1.05rem;
    height: 1.05rem;
    margin: 0;
    accent-color: var(--accent);
    transform: translateY(0.15rem);
  }
  ol {
    margin: 0.3rem 0 0.5rem;
    list-style: none;
  }
  li {
    display: grid;
    grid-template-columns: 1.1rem minmax(0, 1fr) auto;
    gap: 0.4rem;
  }
  label .number {
    margin-left: auto;
  }
  .number {
    color: var(--soft);
    font-size: 0.75rem;
  }
  .good {
    color: var(--good);
  }
  .bad {
    color: var(--bad);
  }
  .save {
    display: flex;
    flex-wrap: wrap;
    gap: 0.4rem;
  }
  .save input {
    flex: 1;
    min-width: 8rem;
    min-height: 2rem;
    padding: 0 0.5rem;
    border: 1px solid var(--line);
    border-radius: 6px;
    background: var(--well);
  }
  .save button,
  .moodle button {
    padding: 0 0.8rem;
  }
  @container (min-width: 1500px) {
    :host {
      font-size: 0.9375rem;
    }
  }
  @media print {
    :host {
      overflow: hidden;
    }
    ol {
      columns: 2;
    }
    .choice,
    .next,
    .save button,
    .moodle button {
      display: none;
    }
  }
`;

/** How the list of answers marks each of them. */
const marks = {
  right: ['good', '✓'],
  some: ['bad', '✗'],
  wrong: ['bad', '✗'],
  givenUp: ['', '–'],
} as const;

/** The panel of predictions: the current question, the settings of questions, and the score. */
@customElement('vidno-predict')
export class PredictElement extends LitElement {
  static override styles = [base, predictStyle];

  @property({ attribute: false }) view!: View;
  @property({ attribute: false }) predictor!: Predictor;
  /** A run without questions, after the reader has asked for one. */
  @state() private withoutAny: Header | null = null;
  private name = '';

  private get say(): PredictTexts {
    return texts[this.view.language].predict;
  }

  override render(): TemplateResult {
    const { current } = this.predictor;
    const score = this.predictor.score();
    return html`
      ${current === null ? this.nothingAsked() : this.asked(current)} ${this.choice(score)}
      ${this.kept()} ${this.score(score)} ${this.moodle()}
    `;
  }

  private nothingAsked(): TemplateResult {
    const { say, predictor } = this;
    return html`<section>
      <p class="hint">${predictor.isOver ? nothing : say.hint(liveKey('Q'))}</p>
      <p role="status">${predictor.isOver ? say.none : nothing}</p>
      <button class="next" @click=${() => predictor.next()}>${say.next} ${kbd('Q')}</button>
    </section>`;
  }

  private asked(current: Current): TemplateResult {
    const { say, predictor, view } = this;
    const { step } = current.question;
    if (predictor.isOpen && step !== view.step) {
      return html`<section>
        <button class="next" @click=${() => predictor.next()}>${say.waits(step)}</button>
      </section>`;
    }
    return html`<section>
      <vidno-question
        .view=${view}
        .predictor=${predictor}
        .current=${current}
        .reasons=${predictor.reasons}
        @command=${({ detail }: CustomEvent<Command>) => this.ask(detail)}
      ></vidno-question>
      <p role="status">${predictor.isOver ? say.none : nothing}</p>
    </section>`;
  }

  private choice(score: Score): TemplateResult {
    const { say, predictor } = this;
    return html`<section class="choice">
      <label title=${say.forcedHint}>
        <input
          class="force"
          type="checkbox"
          .checked=${predictor.isForced}
          @change=${({ target }: Event) => predictor.force((target as HTMLInputElement).checked)}
        />
        <span>${say.forced}<small>${say.forcedHint}</small></span>
      </label>
      <fieldset>
        <legend>${say.askAbout}</legend>
        ${predictor.offered.map((kind) => this.kind(kind, score))}
      </fieldset>
    </section>`;
  }

  private kind(kind: Kind, { kinds }: Score): TemplateResult {
    const { say, predictor } = this;
    const { asked, right } = kinds[kind] ?? { asked: 0, right: 0 };
    return html`<label>
      <input
        type="checkbox"
        .checked=${predictor.wanted.has(kind)}
        @change=${({ target }: Event) => predictor.want(kind, (target as HTMLInputElement).checked)}
      />
      <span>${say.kinds[kind]}</span>
      ${
        asked === 0
          ? nothing
          : html`<span class="number" title=${say.counted(right, asked)}>${right} / ${asked}</span>`
      }
    </label>`;
  }

  private score({ total }: Score): TemplateResult | typeof nothing {
    const { say, predictor, view } = this;
    const { record } = predictor;
    const { asked, right, points, parts } = total;
    if (asked === 0) return nothing;
    return html`<section class="score">
      <h3>${say.score}</h3>
      <p><b>${say.counted(right, asked)}</b></p>
      <p>${say.points(texts[view.language].numbers.short(points), parts)}</p>
      <p class="hint">${say.first}</p>
      ${asked > record.length ? html`<p>${say.earlier(asked - record.length)}</p>` : nothing}
      <ol>
        ${record.map((answered) => this.answered(answered))}
      </ol>
      <div class="save">
        <input
          type="text"
          aria-label=${say.name}
          placeholder=${say.name}
          autocomplete="off"
          .value=${this.name}
          @input=${({ target }: Event) => (this.name = (target as HTMLInputElement).value)}
        />
        <button title=${say.saveHint} @click=${() => this.save()}>${say.save}</button>
      </div>
    </section>`;
  }

  private answered(answered: Answered): TemplateResult {
    const { say } = this;
    const how = howWell(answered.given, answered.right);
    const [looks, mark] = marks[how];
    const { kind, step } = answered.question;
    return html`<li>
      <b class=${looks} title=${say.verdicts[how]}>${mark}</b>
      <span>${say.kinds[kind]}</span> <span class="number">${step}</span>
    </li>`;
  }

  /** What a learning management system has of the score. */
  private kept(): TemplateResult | typeof nothing {
    const { say, predictor, view } = this;
    if (predictor.keeper === null) return nothing;
    const { percent, left } = predictor.keeper;
    const kept =
      percent === null ? say.notKept : say.kept(texts[view.language].numbers.short(percent), left);
    return html`<section class="kept" role="status">${kept}</section>`;
  }

  private save(): void {
    const score = this.predictor.score(this.name.trim());
    const file = new Blob([`${JSON.stringify(score, null, 2)}\n`], { type: 'application/json' });
    download(file, fileName('score', this.name, 'json'));
  }

  private moodle(): TemplateResult {
    const { say, view } = this;
    return html`<section class="moodle">
      <button title=${say.moodleHint} @click=${() => this.saveMoodle()}>${say.moodle}</button>
      <p role="status">${this.withoutAny === view.header ? say.moodleNone : nothing}</p>
    </section>`;
  }

  private saveMoodle(): void {
    const { header } = this.view;
    const xml = this.predictor.moodle();
    this.withoutAny = xml === null ? header : null;
    if (xml === null) return;
    const { scene, method, kernel, edition } = header;
    const name = `${fileName(scene.name, method, kernel, edition, 'questions')}.xml`;
    download(new Blob([xml], { type: 'application/xml' }), name);
  }

  private ask(detail: Command): void {
    this.dispatchEvent(new CustomEvent<Command>('command', { detail }));
  }
}
