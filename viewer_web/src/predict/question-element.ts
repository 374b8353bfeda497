import { LitElement, html, nothing } from 'lit';
import type { PropertyValues, TemplateResult } from 'lit';
import { customElement, property, query, state } from 'lit/decorators.js';
import { live } from 'lit/directives/live.js';
import type { View } from '../algorithm/view.js';
import { hiddenStyle } from '../elements/hidden.style.js';
import { kbd } from '../elements/kbd.js';
import { base } from '../elements/theme.js';
import { texts } from '../i18n/index.js';
import type { PredictTexts } from '../language/predict-texts.js';
import type { Command } from '../time/command.js';
import { optionName, valueName } from './answers.js';
import { typedRow } from './grade.js';
import type { Current, Predictor } from './predictor.js';
import { parts as forms } from './question.js';
import type { Part } from './question.js';
import { questionStyle } from './question.style.js';
import type { Reason } from './reasons.js';
import { sayIntro, sayRight } from './say.js';

/** A question as a form, and the result of the answer. */
@customElement('vidno-question')
export class QuestionElement extends LitElement {
  static override styles = [base, hiddenStyle, questionStyle];

  @property({ attribute: false }) view!: View;
  @property({ attribute: false }) predictor!: Predictor;
  @property({ attribute: false }) current!: Current;
  @property({ attribute: false }) reasons: readonly Reason[] = [];
  /** The chosen values of each part; for a row, the typed text. */
  @state() private chosen: readonly (readonly string[])[] = [];
  @state() private isMissing = false;
  @query('h3') private heading!: HTMLElement;
  @query('.result') private result!: HTMLElement | null;

  private get say(): PredictTexts {
    return texts[this.view.language].predict;
  }

  override willUpdate(changed: PropertyValues<this>): void {
    if (!changed.has('current')) return;
    this.isMissing = false;
    const isOther = changed.get('current')?.question !== this.current.question;
    if (isOther) this.chosen = this.current.question.parts.map(() => []);
  }

  override updated(changed: PropertyValues<this>): void {
    if (!changed.has('current')) return;
    const goal = this.current.verdict === null ? this.heading : this.result;
    goal?.focus();
  }

  /** The answer; null for each part without one. */
  private get answer(): readonly (readonly string[] | null)[] {
    return this.current.question.parts.map((part, i) => {
      const chosen = this.chosen[i] ?? [];
      const [form] = forms[part.asks];
      if (form === 'row') return typedRow(part, chosen[0] ?? '');
      return form === 'one' && chosen.length === 0 ? null : chosen;
    });
  }

  private onSubmit(event: Event): void {
    event.preventDefault();
    const { answer } = this;
    const missing = answer.indexOf(null);
    this.isMissing = missing >= 0;
    if (this.isMissing) this.inputsOf(missing)[0]?.focus();
    else this.predictor.answer(answer);
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

  private choose(part: number, values: readonly string[]): void {
    this.chosen = this.chosen.map((old, i) => (i === part ? values : old));
  }

  override render(): TemplateResult {
    const { view } = this;
    const { question, verdict } = this.current;
    return html`<form @submit=${this.onSubmit} @keydown=${this.onKey} novalidate autocomplete="off">
      <h3 tabindex="-1">${sayIntro(question, view.language)}</h3>
      ${question.parts.map((part, i) => this.field(part, i))}
      ${verdict === null ? this.toDo() : this.judged(verdict)}
    </form>`;
  }

  private field(part: Part, i: number): TemplateResult {
    const { say, view } = this;
    const { verdict } = this.current;
    const [form] = forms[part.asks];
    const isRight = verdict?.right[i] === true;
    const given = (part.given ?? []).map(
      (each) => html`<li>${valueName(each.of, each, view)}</li>`,
    );
    return html`<fieldset data-part=${i} ?disabled=${verdict !== null}>
      <legend>${say.asks[part.asks]} ${verdict === null ? nothing : this.mark(isRight)}</legend>
      ${
        given.length === 0
          ? nothing
          : html`<ul class="given">
              ${given}
            </ul>`
      }
      ${form === 'row' ? this.row(part, i) : this.options(part, i, form === 'one')}
      ${
        verdict === null || isRight
          ? nothing
          : html`<p class="right">${say.rightIs(sayRight(part, view.language))}</p>`
      }
    </fieldset>`;
  }

  private mark(isRight: boolean): TemplateResult {
    const said = isRight ? this.say.partRight : this.say.partWrong;
    return html`<b class=${isRight ? 'good' : 'bad'}>${isRight ? '✓' : '✗'} ${said}</b>`;
  }

  private options(part: Part, i: number, isOne: boolean): TemplateResult {
    const chosen = this.chosen[i] ?? [];
    const change = (value: string): void => {
      const others = isOne ? [] : chosen.filter((each) => each !== value);
      this.choose(i, !isOne && chosen.includes(value) ? others : [...others, value]);
    };
    return html`<div class="options">
      ${part.options.map(
        (option, n) =>
          html`<label>
            <input
              type=${isOne ? 'radio' : 'checkbox'}
              name=${part.asks}
              .checked=${live(chosen.includes(option.value))}
              @change=${() => change(option.value)}
            />
            <kbd aria-hidden="true">${n < 9 ? n + 1 : nothing}</kbd>
            <span>${optionName(part.asks, option, this.view)}</span>
          </label>`,
      )}
    </div>`;
  }

  private row({ asks }: Part, i: number): TemplateResult {
    const { say } = this;
    const hint = say.rows[asks as keyof PredictTexts['rows']];
    return html`<input
        type="text"
        aria-label=${say.asks[asks]}
        aria-describedby="row-${i}"
        spellcheck="false"
        autocapitalize="off"
        .value=${live(this.chosen[i]?.[0] ?? '')}
        @input=${({ target }: Event) => this.choose(i, [(target as HTMLInputElement).value])}
      />
      <p class="hint" id="row-${i}">${hint}</p>`;
  }

  private toDo(): TemplateResult {
    const { say } = this;
    return html`<p class="missing" role="status">${this.isMissing ? say.missing : nothing}</p>
      <div class="buttons to-do">
        <button class="main" type="submit">${say.check} <kbd>Enter</kbd></button>
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
    const how = given === null ? 'givenUp' : right.every(Boolean) ? 'right' : 'wrong';
    return html`
      <p class="result ${how}" role="status" tabindex="-1">${say.verdicts[how]}</p>
      <h4>${say.because}</h4>
      <ol class="reasons">
        ${this.reasons.map(
          ({ step, said }) =>
            html`<li>
              <button type="button" @click=${() => this.goTo(step)}>
                <span>${said}</span> <span class="number">${step}</span>
              </button>
            </li>`,
        )}
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
