import { LitElement, css, html, nothing } from 'lit';
import type { PropertyValues, TemplateResult } from 'lit';
import { customElement, property, query, state } from 'lit/decorators.js';
import { live } from 'lit/directives/live.js';
import type { View } from '../algorithm/view.js';
import { kbd } from '../elements/keyboard.js';
import { base, hiddenStyle } from '../elements/theme.js';
import { texts } from '../i18n/index.js';
import type { PredictTexts } from '../language/texts.js';
import type { Command } from '../time/travel.js';
import { optionName, valueName } from './answers.js';
import type { Current, Predictor } from './predictor.js';
import { columnsOf, parts as forms } from './question.js';
import type { Part } from './question.js';
import type { Reason } from './say.js';
import {
  sayAnswer,
  sayCell,
  sayEntry,
  sayIntro,
  sayRight,
  sayRightCell,
  stepAgainst,
} from './say.js';
import { howWell, isRightNumber, typedNumber } from './grade.js';
import { answerOf, firstWrong, hintCost } from './sheet.js';
import type { Wrong } from './sheet.js';

const questionStyle = css`
  :host {
    display: block;
  }
  h3 {
    color: var(--ink);
    font-size: 1em;
    letter-spacing: 0;
    overflow-wrap: anywhere;
  }
  h3 + .hint {
    margin-top: 0.4rem;
  }
  h3:focus-visible,
  .result:focus-visible {
    outline-offset: 3px;
    border-radius: 3px;
  }
  fieldset {
    margin: 0.6rem 0 0;
  }
  legend {
    font-weight: 600;
  }
  /* The part that the picture answers, and for which there is a hint. */
  .current {
    margin-left: -0.6rem;
    padding-left: calc(0.6rem - 3px);
    border-left: 3px solid var(--accent);
  }
  .good {
    color: var(--good);
  }
  .bad {
    color: var(--bad);
  }
  .options {
    display: flex;
    flex-wrap: wrap;
    gap: 0 1.25rem;
  }
  .options:has(.note) {
    display: block;
  }
  label {
    display: flex;
    gap: 0.4rem;
    align-items: baseline;
    min-height: 1.625rem;
    padding: 0.15rem 0;
    cursor: pointer;
    overflow-wrap: anywhere;
  }
  fieldset:disabled label {
    cursor: default;
  }
  fieldset:disabled label:has(:checked) {
    font-weight: 600;
  }
  /* Where the picture stays in sight, it covers the upper part of the screen. */
  :is(h3, .result, input, button) {
    scroll-margin-top: var(--covered, 0px);
  }
  label input {
    flex: none;
    width: 1.05rem;
    height: 1.05rem;
    margin: 0;
    accent-color: var(--accent);
    align-self: center;
  }
  kbd {
    color: var(--soft);
    font: 0.6875rem var(--mono);
  }
  .note {
    color: var(--soft);
    font-size: 0.85em;
  }
  .given {
    padding: 0.15rem 0;
    list-style: none;
  }
  input[type='text'] {
    width: 100%;
    min-height: 2rem;
    margin-top: 0.2rem;
    padding: 0 0.5rem;
    border: 1px solid var(--soft);
    border-radius: 6px;
    background: var(--well);
    font-family: var(--mono);
  }
  table {
    margin-top: 0.2rem;
  }
  th,
  td {
    padding: 0.1rem 0.5rem 0.1rem 0;
    font-weight: 400;
    text-align: left;
  }
  td input[type='text'] {
    width: 7em;
    margin-top: 0;
  }
  [aria-invalid='true'] {
    border-color: var(--bad);
    color: var(--bad);
  }
  .hint {
    color: var(--soft);
    font-size: 0.92em;
  }
  .right,
  .first-wrong {
    font-weight: 600;
  }
  /* Nothing moves when the reader turns to another part, or a click could miss. */
  .away {
    visibility: hidden;
  }
  .hinted {
    color: var(--soft);
  }
  .ruled-out span {
    color: var(--soft);
    text-decoration: line-through;
  }
  .entries {
    display: flex;
    flex-wrap: wrap;
    gap: 0.25rem;
    margin-top: 0.25rem;
  }
  .entries button {
    min-width: 2rem;
    min-height: 1.75rem;
    font-family: var(--mono);
  }
  .buttons {
    display: flex;
    flex-wrap: wrap;
    gap: 0.4rem;
    margin-top: 0.7rem;
  }
  .buttons button {
    padding: 0 0.8rem;
  }
  /* In sight however long the question is. */
  .to-do {
    position: sticky;
    bottom: 0;
    margin: 0.4rem 0 -0.6rem;
    padding: 0.3rem 0 0.6rem;
    background: var(--panel);
  }
  .main {
    border-color: var(--accent);
    background: var(--accent);
    color: var(--on-accent);
  }
  .main kbd {
    color: inherit;
  }
  .missing:not(:empty) {
    margin-top: 0.9rem;
    padding: 0.3rem 0.6rem;
    border-radius: 6px;
    background: var(--warn-wash);
    color: var(--warn);
  }
  .result {
    margin-top: 0.7rem;
    padding: 0.35rem 0.6rem;
    border-left: 3px solid currentColor;
    background: var(--well);
    font-weight: 700;
  }
  .result.right {
    color: var(--good);
  }
  .result:is(.some, .wrong) {
    color: var(--bad);
  }
  .result.givenUp {
    color: var(--soft);
  }
  h4 {
    margin: 0.6rem 0 0.1rem;
    font-size: 0.92em;
    color: var(--soft);
  }
  .reasons {
    margin: 0 -0.75rem;
    list-style: none;
  }
  .reasons button {
    display: grid;
    grid-template-columns: minmax(0, 1fr) auto;
    gap: 0.5rem;
    width: 100%;
    min-height: 1.75rem;
    padding: 0.15rem 0.75rem;
    border: 0;
    border-radius: 0;
    background: none;
    text-align: left;
    overflow-wrap: anywhere;
  }
  .reasons button:hover {
    background: var(--well);
  }
  .reasons button:focus-visible {
    outline-offset: -3px;
  }
  .reasons .number {
    color: var(--soft);
    font-size: 0.6875rem;
    line-height: 1.65;
  }
  /* Above the time controls, which stay at the bottom there. */
  @container (max-width: 960px) {
    input,
    button,
    .result,
    h3 {
      scroll-margin: 1rem 0 18rem;
    }
  }
  @media print {
    .buttons,
    .missing {
      display: none;
    }
  }
`;

/** A question as a form, and the result of the answer. */
@customElement('vidno-question')
export class QuestionElement extends LitElement {
  static override styles = [base, hiddenStyle, questionStyle];

  @property({ attribute: false }) view!: View;
  @property({ attribute: false }) predictor!: Predictor;
  @property({ attribute: false }) current!: Current;
  @property({ attribute: false }) reasons: readonly Reason[] = [];
  @state() private isMissing = false;
  @query('h3') private heading!: HTMLElement;
  @query('.result') private result!: HTMLElement | null;

  private get say(): PredictTexts {
    return texts[this.view.language].predict;
  }

  override willUpdate(changed: PropertyValues<this>): void {
    if (!changed.has('current')) return;
    const before = changed.get('current');
    if (before?.question !== this.current.question) this.isMissing = false;
  }

  override updated(changed: PropertyValues<this>): void {
    if (!changed.has('current')) return;
    const before = changed.get('current');
    const { question, verdict, turn } = this.current;
    const isSame = before?.question === question && before.verdict === verdict;
    if (isSame && before.turn === turn) return;
    const goal = this.current.verdict === null ? this.heading : this.result;
    goal?.focus();
  }

  private onSubmit(event: Event): void {
    event.preventDefault();
    const { question, sheet } = this.current;
    const missing = answerOf(question, sheet).indexOf(null);
    this.isMissing = missing >= 0;
    if (!this.isMissing) {
      this.predictor.answer();
      return;
    }
    const inputs = this.inputsOf(missing);
    const isEmpty = ({ type, value }: HTMLInputElement): boolean =>
      type === 'text' && typedNumber(value) === null;
    (inputs.find(isEmpty) ?? inputs[0])?.focus();
  }

  private inputsOf(part: number): readonly HTMLInputElement[] {
    return [...this.renderRoot.querySelectorAll<HTMLInputElement>(`[data-part="${part}"] input`)];
  }

  /** A digit chooses among the options of the part in focus, or of the first one. */
  private onKey(event: KeyboardEvent): void {
    const { target } = event;
    const isTyping = target instanceof HTMLInputElement && target.type === 'text';
    if (isTyping || !/^[1-9]$/.test(event.key) || event.ctrlKey || event.altKey) return;
    const within = target instanceof Element ? target.closest('fieldset') : null;
    const option = this.inputsOf(Number(within?.dataset['part'] ?? 0))[Number(event.key) - 1];
    if (option === undefined || option.type === 'text') return;
    event.preventDefault();
    option.focus();
    option.click();
  }

  override render(): TemplateResult {
    const { view } = this;
    const { question, verdict } = this.current;
    const isInPicture = (view.targets ?? []).length > 0;
    return html`<form @submit=${this.onSubmit} @keydown=${this.onKey} novalidate autocomplete="off">
      <h3 tabindex="-1">${sayIntro(question, view.language)}</h3>
      ${verdict === null ? html`<p class=${isInPicture ? 'hint' : 'hint away'}>${this.say.inPicture}</p>` : nothing}
      ${question.parts.map((part, i) => this.field(part, i))}
      ${verdict === null ? this.toDo() : this.judged(verdict)}
    </form>`;
  }

  private field(part: Part, i: number): TemplateResult {
    const { say, view } = this;
    const { verdict } = this.current;
    const isRight = verdict?.right[i] === true;
    const isCurrent = verdict === null && i === this.current.part;
    const given = (part.given ?? []).map(
      (each) => html`<li>${valueName(each.of, each, view)}</li>`,
    );
    return html`<fieldset
      data-part=${i}
      class=${isCurrent ? 'current' : ''}
      @pointerdown=${() => this.predictor.turnTo(i)}
      ?disabled=${verdict !== null}
      @focusin=${() => this.predictor.turnTo(i)}
    >
      <legend>${say.asks[part.asks]} ${verdict?.given ? this.mark(isRight) : nothing}</legend>
      ${
        given.length === 0
          ? nothing
          : html`<ul class="given">
              ${given}
            </ul>`
      }
      ${this.answer(part, i)} ${this.hinted(part, i)}
      ${
        verdict === null || isRight
          ? nothing
          : html`<p class="right">${say.rightIs(sayRight(part, view.language))}</p>
              ${this.firstWrong(part, verdict.given?.[i] ?? null)}`
      }
    </fieldset>`;
  }

  /** The part's place for an answer. */
  private answer(part: Part, i: number): TemplateResult {
    const [form] = forms[part.asks];
    if (form === 'table') return this.table(part, i);
    return form === 'row' ? this.row(part, i) : this.options(part, i, form === 'one');
  }

  /** What the last hint for a part said. */
  private hinted(part: Part, i: number): TemplateResult | typeof nothing {
    const { say, view, current } = this;
    const { hinted } = current.sheet[i] ?? {};
    if (hinted === undefined || current.verdict !== null) return nothing;
    const [form] = forms[part.asks];
    const entry = (value: string): string =>
      form === 'table'
        ? sayRightCell(part, Number(value), view.language)
        : sayAnswer(part, value, view.language);
    const said = hinted === null ? say.hintedNothing : say.hinted[form](entry(hinted));
    return html`<p class="hinted" role="status">${said}</p>`;
  }

  /** Gives a hint for the part in hand. */
  private hint(): TemplateResult | typeof nothing {
    const { say, view, current } = this;
    const part = current.question.parts[current.part];
    if (part === undefined || current.isAnswered) return nothing;
    const cost = texts[view.language].numbers.short(Math.round(hintCost(part) * 100) / 100);
    return html`<button
      type="button"
      title=${say.hintCosts(cost)}
      @click=${() => this.predictor.hint(current.part)}
    >
      ${say.hintFor} <span class="note">−${cost}</span>
    </button>`;
  }

  /** The first wrong entry of an answer, and the step that decides it. */
  private firstWrong(part: Part, given: readonly string[] | null): TemplateResult | typeof nothing {
    const wrong = given && firstWrong(part, given);
    if (wrong === null || forms[part.asks][0] === 'one') return nothing;
    const { say, current } = this;
    const entry = this.wrongEntry(part, wrong);
    const step = stepAgainst(current.question, part, wrong);
    const reason = this.reasons.find((each) => each.step === step);
    return html`<p class="first-wrong">${say.firstWrong(entry)}</p>
      ${reason === undefined ? nothing : html`<div class="reasons">${this.reason(reason)}</div>`}`;
  }

  private wrongEntry(part: Part, { value, at }: Wrong): string {
    const { language } = this.view;
    if (value === null) return this.say.tooLong;
    return forms[part.asks][0] === 'table'
      ? sayRightCell(part, at, language)
      : sayEntry(part, value, language);
  }

  private reason({ step, said }: Reason): TemplateResult {
    return html`<button type="button" @click=${() => this.goTo(step)}>
      <span>${said}</span> <span class="number">${step}</span>
    </button>`;
  }

  private mark(isRight: boolean): TemplateResult {
    const said = isRight ? this.say.partRight : this.say.partWrong;
    return html`<b class=${isRight ? 'good' : 'bad'}>${isRight ? '✓' : '✗'} ${said}</b>`;
  }

  private options(part: Part, i: number, isOne: boolean): TemplateResult {
    const { chosen = [], ruledOut = [] } = this.current.sheet[i] ?? {};
    return html`<div class="options">
      ${part.options.map(
        (option, n) =>
          html`<label class=${ruledOut.includes(option.value) ? 'ruled-out' : ''}>
            <input
              type=${isOne ? 'radio' : 'checkbox'}
              name=${part.asks}
              ?disabled=${ruledOut.includes(option.value)}
              .checked=${live(chosen.includes(option.value))}
              @change=${() => this.predictor.press(i, option.value)}
            />
            <kbd aria-hidden="true">${n < 9 ? n + 1 : nothing}</kbd>
            <span>${optionName(part.asks, option, this.view)}</span>
          </label>`,
      )}
    </div>`;
  }

  private row({ asks, options }: Part, i: number): TemplateResult {
    const { say, predictor } = this;
    const hint = say.rows[asks as keyof PredictTexts['rows']];
    return html`<input
        type="text"
        aria-label=${say.asks[asks]}
        aria-describedby="row-${i}"
        spellcheck="false"
        autocapitalize="off"
        .value=${live(this.current.sheet[i]?.chosen[0] ?? '')}
        @input=${({ target }: Event) => predictor.type(i, (target as HTMLInputElement).value)}
      />
      <div class="entries">
        ${options.map(
          ({ value }) =>
            html`<button type="button" tabindex="-1" @click=${() => predictor.press(i, value)}>
              ${value.replace('-', '−')}
            </button>`,
        )}
      </div>
      <p class="hint" id="row-${i}">${hint}</p>`;
  }

  private table(part: Part, i: number): TemplateResult {
    const { say, current } = this;
    const { language } = this.view;
    const { chosen = [] } = current.sheet[i] ?? {};
    const { entry, columns: names, hint } = say.table;
    const columns = columnsOf(part);
    const cell = (at: number): TemplateResult => {
      const text = chosen[at] ?? '';
      const isWrong = current.verdict?.given && !isRightNumber(text, part.right[at] ?? '');
      return html`<td>
        <input
          type="text"
          inputmode="decimal"
          aria-label=${sayCell(part, at, language)}
          aria-describedby="table-${i}"
          aria-invalid=${isWrong ? 'true' : 'false'}
          .value=${live(text)}
          @input=${({ target }: Event) => this.predictor.fillIn(i, at, (target as HTMLInputElement).value)}
        />
      </td>`;
    };
    const rows = Array.from({ length: part.right.length / columns.length }, (_, row) => row);
    return html`<table>
        <thead>
          <tr>
            <td></td>
            ${columns.map((each) => html`<th scope="col">${names[each]}</th>`)}
          </tr>
        </thead>
        <tbody>
          ${rows.map(
            (row) =>
              html`<tr>
                <th scope="row">${rows.length === 1 ? nothing : entry(row + 1)}</th>
                ${columns.map((_, column) => cell(row * columns.length + column))}
              </tr>`,
          )}
        </tbody>
      </table>
      <p class="hint" id="table-${i}">${hint}</p>`;
  }

  private toDo(): TemplateResult {
    const { say } = this;
    return html`<p class="missing" role="status">${this.isMissing ? say.missing : nothing}</p>
      <div class="buttons to-do">
        <button class="main" type="submit">${say.check} <kbd>Enter</kbd></button>
        ${this.hint()}
        ${
          this.current.isAnswered
            ? nothing
            : html`<button type="button" @click=${() => this.predictor.giveUp()}>
                ${say.giveUp}
              </button>`
        }
      </div>`;
  }

  private judged({ given, right }: NonNullable<Current['verdict']>): TemplateResult {
    const { say } = this;
    const how = howWell(given, right);
    return html`
      <p class="result ${how}" role="status" tabindex="-1">${say.verdicts[how]}</p>
      <h4>${say.because}</h4>
      <ol class="reasons">
        ${this.reasons.map((reason) => html`<li>${this.reason(reason)}</li>`)}
      </ol>
      <div class="buttons">
        <button class="main" type="button" @click=${() => this.predictor.next()}>
          ${say.next} ${kbd('Q')}
        </button>
        ${
          how === 'right'
            ? nothing
            : html`<button type="button" @click=${() => this.predictor.again()}>
                ${say.again}
              </button>`
        }
      </div>
    `;
  }

  private goTo(step: number): void {
    const detail: Command = { do: 'seek', step };
    this.dispatchEvent(new CustomEvent<Command>('command', { detail }));
  }
}
