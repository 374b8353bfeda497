import { LitElement, css, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { texts } from '../i18n/index.js';
import type { Language } from '../language/language.js';
import { headerStyle } from '../elements/header.style.js';
import { kbd } from '../elements/kbd.js';
import '../elements/languages.js';
import { base } from '../elements/theme.js';

/**
 * The line at the top of the page. Events `skip`, to the run, `keys`, `text`, `compare`, `present` and `choose`, of a language, tell what
 * is asked for.
 */
@customElement('vidno-page-header')
export class PageHeaderElement extends LitElement {
  static override styles = [
    base,
    headerStyle,
    css`
      button {
        padding: 0 0.7rem;
        white-space: nowrap;
      }
      kbd {
        font: 0.8125rem var(--mono);
        color: var(--soft);
      }
      header {
        height: 100%;
      }
      button[aria-pressed='true'] {
        border-color: var(--accent);
        background: var(--accent-wash);
      }
      .skip:not(:focus-visible) {
        position: absolute;
        width: 1px;
        min-height: 1px;
        padding: 0;
        overflow: hidden;
        clip-path: inset(50%);
      }
      @media (max-width: 640px) {
        .tools {
          gap: 0.35rem;
        }
        button {
          padding: 0 0.5rem;
        }
        .present,
        :host([told]) .keys,
        kbd {
          display: none;
        }
      }
      @media (max-width: 380px) {
        .tools {
          gap: 0.25rem;
        }
        button {
          padding: 0 0.3rem;
        }
      }
    `,
  ];

  @property({ attribute: false }) language: Language = 'en';
  /** Whether a run is shown, which the tools are for. */
  @property({ type: Boolean }) open = false;
  /** Whether another run is beside it. */
  @property({ type: Boolean }) comparing = false;
  /** Whether no other run may be. */
  @property({ type: Boolean }) alone = false;

  /** Whether the lesson has a text, and whether that is shown. */
  @property({ type: Boolean, reflect: true }) told = false;
  @property({ type: Boolean }) reading = false;
  /** Which keys there are, as an address has it. */
  @property({ attribute: false }) keys = '';

  override render(): TemplateResult {
    const { page, compare, reader } = texts[this.language];
    return html`<header>
      <button class="skip" @click=${() => this.ask('skip')}>${page.skip}</button>
      <h1>vidno</h1>
      <p class="tagline">${page.tagline}</p>
      <div class="tools">
        ${
          this.told
            ? html`<button
                aria-pressed=${this.reading ? 'true' : 'false'}
                title=${this.reading ? reader.hide : nothing}
                @click=${() => this.ask('text')}
              >
                ${reader.text} ${kbd('R')}
              </button>`
            : nothing
        }
        <button class="keys" @click=${() => this.ask('keys')} ?disabled=${!this.open}>
          ${page.keys} ${kbd('?')}
        </button>
        <button
          aria-pressed=${this.comparing ? 'true' : 'false'}
          title=${this.comparing ? compare.leave : nothing}
          @click=${() => this.ask('compare')}
          ?disabled=${!this.open || this.alone}
        >
          ${compare.compare} ${kbd('D')}
        </button>
        <button class="present" @click=${() => this.ask('present')} ?disabled=${!this.open}>
          ${page.present} ${kbd('F')}
        </button>
        <vidno-languages
          .chosen=${this.language}
          @choose=${({ detail }: CustomEvent<Language>) => this.ask('choose', detail)}
        ></vidno-languages>
      </div>
    </header>`;
  }

  private ask(
    what: 'skip' | 'keys' | 'text' | 'compare' | 'present' | 'choose',
    detail: Language | null = null,
  ): void {
    this.dispatchEvent(new CustomEvent(what, { detail }));
  }
}
