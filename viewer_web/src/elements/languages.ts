import { LitElement, css, html } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { languageNames, languages } from '../language/language.js';
import type { Language } from '../language/language.js';
import { base } from './theme.js';

/** The choice of language. */
@customElement('vidno-languages')
export class LanguagesElement extends LitElement {
  static override styles = [
    base,
    css`
      div {
        display: flex;
      }
      button {
        padding: 0 0.7rem;
      }
      button:first-child {
        border-radius: 6px 0 0 6px;
      }
      button:last-child {
        border-radius: 0 6px 6px 0;
        border-left: 0;
      }
      @media (max-width: 380px) {
        button {
          padding: 0 0.4rem;
        }
      }
      button[aria-pressed='true'] {
        background: var(--accent);
        border-color: var(--accent);
        color: var(--on-accent);
      }
    `,
  ];

  @property({ attribute: false }) chosen: Language = 'en';

  override render(): TemplateResult {
    return html`<div role="group">${languages.map((each) => this.button(each))}</div>`;
  }

  private button(language: Language): TemplateResult {
    return html`<button
      lang=${language}
      title=${languageNames[language]}
      aria-pressed=${language === this.chosen ? 'true' : 'false'}
      @click=${() => this.dispatchEvent(new CustomEvent('choose', { detail: language }))}
    >
      ${language.toUpperCase()}
    </button>`;
  }
}
