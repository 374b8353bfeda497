import { LitElement, css, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property, query, state } from 'lit/decorators.js';
import { live } from 'lit/directives/live.js';
import { quickRuns } from './rival.js';
import type { With } from './rival.js';
import type { CompareTexts } from '../language/texts.js';
import { texts } from '../i18n/index.js';
import type { Language } from '../language/language.js';
import { idOf } from '../lessons/lessons.js';
import type { Lesson } from '../lessons/lessons.js';
import { runLabel } from '../lessons/run-name.js';
import { kernels, methodNames, offeredNames, runnable, runs, usual } from '../run/options.js';
import type { Options } from '../run/options.js';
import type { Trace } from '../replay/trace.js';
import { base, dialogStyle } from '../elements/theme.js';

type Field = 'method' | 'edition' | 'kernel';
type Names = Readonly<Record<string, string>>;

/** The choice of a run to compare with. An event `with` carries the choice. */
@customElement('vidno-rival-choice')
export class RivalChoiceElement extends LitElement {
  static override styles = [
    base,
    dialogStyle,
    css`
      :host {
        display: contents;
      }
      dialog {
        width: 42rem;
      }
      section {
        margin-top: 1rem;
      }
      .row {
        display: flex;
        flex-wrap: wrap;
        gap: 0.4rem;
        align-items: end;
      }
      .row > label {
        flex: 1 1 7rem;
        min-width: 0;
      }
      label > span {
        display: block;
        color: var(--soft);
        font-size: 0.6875rem;
      }
      select {
        width: 100%;
        padding: 0 0.25rem;
      }
      .row > .method {
        flex-basis: 13rem;
      }
      .row > .lesson {
        flex-basis: 18rem;
      }
      .other {
        margin-top: 0.5rem;
      }
      .rule {
        margin-top: 0.4rem;
        color: var(--soft);
        font-size: 0.75rem;
      }
      button {
        padding: 0 0.8rem;
      }
      input {
        display: none;
      }
      .end {
        justify-content: flex-end;
        margin-top: 1.25rem;
      }
    `,
  ];

  @property({ attribute: false }) language: Language = 'en';
  @property({ attribute: false }) lessons: readonly Lesson[] = [];
  /** The settings of the run; null if the scene cannot be run with other settings. */
  @property({ attribute: false }) options: Options | null = null;
  /** The run before the last change of the scene. */
  @property({ attribute: false }) earlier: Trace | null = null;
  @state() private wanted = usual;
  @query('dialog') private dialog!: HTMLDialogElement;
  @query('input') private input!: HTMLInputElement;
  @query('[name=lesson]') private lesson!: HTMLSelectElement;

  show(): void {
    if (this.options !== null) this.wanted = this.options;
    if (!this.dialog.open) this.dialog.showModal();
  }

  get open(): boolean {
    return this.dialog.open;
  }

  private get say(): CompareTexts {
    return texts[this.language].compare;
  }

  private choose(detail: With): void {
    this.dialog.close();
    this.dispatchEvent(new CustomEvent<With>('with', { detail }));
  }

  override render(): TemplateResult {
    const { say, options, earlier } = this;
    return html`<dialog aria-labelledby="title">
      <h2 id="title">${say.compareWith}</h2>
      <section>
        <h3>${say.sameScene}</h3>
        ${options === null ? html`<p>${say.noLibrary}</p>` : this.otherRuns(options)}
        ${
          earlier === null
            ? nothing
            : html`<p class="row other">
                <button
                  name="before"
                  @click=${() => this.choose({ kind: 'before', trace: earlier })}
                >
                  ${say.quick.before}
                </button>
              </p>`
        }
      </section>
      <section>
        <h3>${say.otherTrace}</h3>
        ${this.otherTraces()}
      </section>
      <p class="row end">
        <button @click=${() => this.dialog.close()}>${say.cancel}</button>
      </p>
    </dialog>`;
  }

  private otherRuns(options: Options): TemplateResult {
    const { say, wanted } = this;
    const { methods, editions } = texts[this.language].page;
    const offered = kernels.filter((kernel) => runs({ ...wanted, kernel }));
    const numbers = Object.fromEntries([...offered, wanted.kernel].map((name) => [name, name]));
    return html`
      <p class="row">
        ${quickRuns(options).map(
          ([name, run]) =>
            html`<button name=${name} @click=${() => this.choose({ kind: 'run', options: run })}>
              ${say.quick[name]}
            </button>`,
        )}
      </p>
      <div class="row other">
        ${this.select('method', methodNames(methods, wanted))}
        ${this.select('edition', offeredNames(wanted, editions))} ${this.select('kernel', numbers)}
        <button name="run" @click=${() => this.choose({ kind: 'run', options: wanted })}>
          ${say.run}
        </button>
      </div>
      <p class="rule">${texts[this.language].family.rules[wanted.method]}</p>
    `;
  }

  private select(field: Field, names: Names): TemplateResult {
    const chosen = this.wanted[field];
    return html`<label class=${field}>
      <span>${texts[this.language].scene[field]}</span>
      <select
        name=${field}
        .value=${live(chosen)}
        @change=${({ target }: Event) => {
          const { value } = target as HTMLSelectElement;
          this.wanted = runnable({ ...this.wanted, [field]: value });
        }}
      >
        ${Object.entries(names).map(
          ([value, name]) =>
            html`<option value=${value} ?selected=${value === chosen}>${name}</option>`,
        )}
      </select>
    </label>`;
  }

  private otherTraces(): TemplateResult {
    const { say, lessons, language } = this;
    const { page } = texts[language];
    const all = lessons.flatMap(({ traces }) => traces);
    return html`<div class="row">
      <label class="lesson">
        <span>${say.ofLessons}</span>
        <select name="lesson">
          ${lessons.map(
            ({ title, traces }) =>
              html`<optgroup label=${title[language]}>
                ${traces.map((each) => html`<option value=${idOf(each)}>${runLabel(each, page, language)}</option>`)}
              </optgroup>`,
          )}
        </select>
      </label>
      <button
        name="open"
        ?disabled=${all.length === 0}
        @click=${() => {
          const lesson = all.find((each) => idOf(each) === this.lesson.value);
          if (lesson !== undefined) this.choose({ kind: 'lesson', lesson });
        }}
      >
        ${say.open}
      </button>
      <button name="file" @click=${() => this.input.click()}>${page.openFile}</button>
      <input type="file" accept=".jsonl,.gz" aria-label=${page.openFile} @change=${this.onFile} />
    </div>`;
  }

  private onFile(): void {
    const [file] = this.input.files ?? [];
    this.input.value = '';
    if (file !== undefined) this.choose({ kind: 'file', file });
  }
}
