import { LitElement, css, html } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property, query, state } from 'lit/decorators.js';
import { base, dialogStyle } from '../elements/theme.js';
import { texts } from '../i18n/index.js';
import type { Language } from '../language/language.js';
import type { Deviation, Edition } from '../trace/editions.js';

/** A line of a listing, and its wrong versions. */
export interface WrongLine {
  readonly at: string;
  readonly text: string;
  readonly wrong: readonly Deviation[];
}

/**
 * The choice of a wrong version of a line. An event `vidno-break`, which bubbles out of all elements, carries the edition.
 */
@customElement('vidno-wrong-lines')
export class WrongLinesElement extends LitElement {
  static override styles = [
    base,
    dialogStyle,
    css`
      :host {
        display: contents;
      }
      dialog {
        width: 40rem;
      }
      section {
        margin-top: 0.9rem;
      }
      h3 {
        display: grid;
        grid-template-columns: 2.75rem 1fr;
        margin-bottom: 0.25rem;
        font: 400 0.8125rem / 1.4 var(--sans);
      }
      h3 span {
        font: 0.6875rem / 1.7 var(--mono);
        color: var(--soft);
      }
      li {
        margin-top: 0.25rem;
        list-style: none;
      }
      li button {
        display: block;
        width: 100%;
        height: auto;
        padding: 0.35rem 0.75rem;
        text-align: left;
        white-space: normal;
        line-height: 1.4;
      }
      b {
        margin-right: 0.5em;
      }
      small {
        color: var(--soft);
        font-size: 0.75rem;
      }
      .end {
        display: flex;
        justify-content: flex-end;
        margin-top: 1.25rem;
      }
      .end button {
        padding: 0 0.8rem;
      }
    `,
  ];

  @property({ attribute: false }) language: Language = 'en';
  @property({ attribute: false }) lines: readonly WrongLine[] = [];
  /** The line to break; null for all lines. */
  @state() private only: string | null = null;
  @query('dialog') private dialog!: HTMLDialogElement;

  /** Offers the wrong versions of a line, or of all lines. */
  async show(only: string | null): Promise<void> {
    this.only = only;
    await this.updateComplete;
    if (!this.dialog.open) this.dialog.showModal();
    this.dialog.querySelector<HTMLElement>('li button')?.focus();
  }

  override render(): TemplateResult {
    const { broken } = texts[this.language].compare;
    const shown = this.lines.filter(({ at }) => this.only === null || at === this.only);
    return html`<dialog aria-labelledby="title" @keydown=${this.onKey}>
      <h2 id="title">${broken.offer}</h2>
      <p>${broken.explained}</p>
      ${shown.map((line) => this.line(line))}
      <p class="end">
        <button @click=${() => this.dialog.close()}>${texts[this.language].compare.cancel}</button>
      </p>
    </dialog>`;
  }

  private line({ at, text, wrong }: WrongLine): TemplateResult {
    return html`<section>
      <h3><span>${at}</span>${text}</h3>
      <ul>
        ${wrong.map((each) => this.variant(each))}
      </ul>
    </section>`;
  }

  private variant({ edition, title, says, defect }: Deviation): TemplateResult {
    const { language } = this;
    const { broken } = texts[language].compare;
    const kind = edition.startsWith('printed:') ? broken.printed : broken.mistake;
    const also = defect !== null && kind === broken.mistake ? ` · ${defect.toUpperCase()}` : '';
    return html`<li>
      <button name=${edition} @click=${() => this.choose(edition)}>
        <b>${title[language]}</b>${says[language]} <small>${kind}${also}</small>
      </button>
    </li>`;
  }

  private choose(detail: Edition): void {
    this.dialog.close();
    const options = { detail, bubbles: true, composed: true };
    this.dispatchEvent(new CustomEvent<Edition>('vidno-break', options));
  }

  /** Arrow keys move between the choices; no key reaches the page behind. */
  private readonly onKey = (event: KeyboardEvent): void => {
    event.stopPropagation();
    const by = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (by === undefined) return;
    event.preventDefault();
    const buttons = [...this.dialog.querySelectorAll<HTMLElement>('li button')];
    const now = buttons.findIndex((each) => each.matches(':focus'));
    buttons.at((now + by) % buttons.length)?.focus();
  };
}
