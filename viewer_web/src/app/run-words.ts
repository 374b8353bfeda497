import { LitElement, css, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property, state } from 'lit/decorators.js';
import { base } from '../elements/theme.js';
import { texts } from '../i18n/index.js';
import { editionName } from '../language/family.js';
import type { Language } from '../language/language.js';
import { isMistake, kernelSays } from '../trace/editions.js';
import type { Header } from '../trace/header.js';

/** The settings of a run in a few words, each of which is explained on demand. */
@customElement('vidno-run-words')
export class RunWordsElement extends LitElement {
  static override styles = [
    base,
    css`
      :host {
        position: relative;
        min-width: 0;
      }
      button {
        max-width: 100%;
        min-height: 1.5rem;
        padding: 0;
        overflow: hidden;
        border-color: transparent;
        background: none;
        color: var(--soft);
        font-size: 0.75rem;
        line-height: 1rem;
        text-overflow: ellipsis;
        white-space: nowrap;
      }
      /* Without room for all words, the rest appear when the reader asks. */
      @media (max-width: 1199px) {
        .more {
          display: none;
        }
      }
      .word {
        text-decoration: underline dotted;
        text-underline-offset: 0.2em;
      }
      dl {
        position: absolute;
        top: calc(100% + 0.4rem);
        left: 0;
        z-index: 6;
        display: grid;
        gap: 0.6rem;
        width: min(28rem, 92vw);
        padding: 0.8rem 1rem;
        border: 1px solid var(--line);
        border-radius: var(--radius);
        background: var(--panel);
        box-shadow: 0 4px 20px rgb(10 12 18 / 30%);
        font-size: 0.875rem;
        line-height: 1.4;
      }
      @media (max-width: 899px) {
        dl {
          position: fixed;
          top: auto;
          right: 0.6rem;
          left: 0.6rem;
          width: auto;
        }
      }
      dl div {
        padding-left: 0.6rem;
        border-left: 3px solid transparent;
      }
      dl .asked {
        border-color: var(--accent);
      }
      dt {
        font-weight: 650;
      }
      dd {
        color: var(--soft);
      }
    `,
  ];

  @property({ attribute: false }) header!: Header;
  @property({ attribute: false }) language: Language = 'en';
  /** The word whose explanation is open; null for none. */
  @state() private asked: number | null = null;

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.close();
  }

  /** The words and their explanations. */
  private get words(): readonly (readonly [word: string, meaning: string])[] {
    const { page, scene, family, words } = texts[this.language];
    const { method, edition, kernel, detail } = this.header;
    const isNamed = edition === 'corrected' || edition === 'printed';
    const kind = isNamed ? edition : isMistake(edition) ? 'mistake' : 'defects';
    return [
      [page.methods[method], family.rules[method]],
      [editionName(page.editions, edition), words.editions[kind]],
      [kernel, kernelSays(kernel)[this.language]],
      [scene.details[detail], words.details[detail]],
    ];
  }

  override render(): TemplateResult {
    const { words, asked } = this;
    const say = texts[this.language].words;
    return html`<button
        aria-expanded=${asked === null ? 'false' : 'true'}
        title=${say.explain}
        @click=${this.onClick}
      >
        ${words.map(
          ([word], i) =>
            html`<span class=${i === 0 ? '' : 'more'}
              >${i === 0 ? '' : ' · '}<span class="word" data-word=${i}>${word}</span></span
            >`,
        )}
      </button>
      ${asked === null ? nothing : this.meanings(asked)}`;
  }

  private meanings(asked: number): TemplateResult {
    return html`<div role="status">
      <dl>
        ${this.words.map(
          ([word, meaning], i) =>
            html`<div class=${i === asked ? 'asked' : nothing}>
              <dt>${word}</dt>
              <dd>${meaning}</dd>
            </div>`,
        )}
      </dl>
    </div>`;
  }

  private readonly onClick = ({ target }: Event): void => {
    const word = Number((target as HTMLElement).dataset['word'] ?? 0);
    if (this.asked === word) this.close();
    else this.open(word);
  };

  private open(word: number): void {
    this.asked = word;
    window.addEventListener('pointerdown', this.onElsewhere);
    window.addEventListener('keydown', this.onKey, { capture: true });
  }

  private close(): void {
    this.asked = null;
    window.removeEventListener('pointerdown', this.onElsewhere);
    window.removeEventListener('keydown', this.onKey, { capture: true });
  }

  private readonly onElsewhere = (event: Event): void => {
    if (!event.composedPath().includes(this)) this.close();
  };

  private readonly onKey = (event: KeyboardEvent): void => {
    if (event.key !== 'Escape') return;
    event.preventDefault();
    this.close();
  };
}
