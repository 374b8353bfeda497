import { LitElement, css, html } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property, query } from 'lit/decorators.js';
import { texts } from '../i18n/index.js';
import type { Language } from '../language/language.js';
import { base, dialogStyle } from '../elements/theme.js';

const answers = ['stay', 'save', 'discard'] as const;
export type DiscardAnswer = (typeof answers)[number];

/** Asks before something else replaces a changed scene. */
@customElement('vidno-discard')
export class DiscardElement extends LitElement {
  static override styles = [
    base,
    dialogStyle,
    css`
      :host {
        display: contents;
      }
      dialog {
        width: 30rem;
      }
      p {
        display: flex;
        flex-wrap: wrap;
        gap: 0.5rem;
        justify-content: flex-end;
        margin-top: 1.25rem;
      }
      button {
        padding: 0 0.9rem;
      }
    `,
  ];

  @property({ attribute: false }) language: Language = 'en';
  @property({ attribute: false }) name = '';
  @query('dialog') private dialog!: HTMLDialogElement;
  private settle: (answer: DiscardAnswer) => void = () => undefined;

  get open(): boolean {
    return this.dialog.open;
  }

  /** Only one question is open at a time: a new one cancels the earlier one. */
  ask(): Promise<DiscardAnswer> {
    this.settle('stay');
    this.dialog.returnValue = 'stay';
    if (!this.dialog.open) this.dialog.showModal();
    return new Promise((resolve) => (this.settle = resolve));
  }

  private onClose(): void {
    this.settle(answers.find((each) => each === this.dialog.returnValue) ?? 'stay');
  }

  override render(): TemplateResult {
    const { discard } = texts[this.language].scene;
    return html`<dialog aria-labelledby="title" @close=${this.onClose}>
      <h2 id="title">${discard.title(this.name)}</h2>
      <div>${discard.text}</div>
      <p>
        ${answers.map(
          (answer) =>
            html`<button name=${answer} @click=${() => this.dialog.close(answer)}>
              ${discard[answer]}
            </button>`,
        )}
      </p>
    </dialog>`;
  }
}
