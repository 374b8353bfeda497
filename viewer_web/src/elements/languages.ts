import { LitElement, css, html } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { languageNames, languages } from '../language/language.js';
import type { Language } from '../language/language.js';
import { base } from './theme.js';

/** Links to the same page in other languages. An event `choose` carries the language. */
@customElement('vidno-languages')
export class LanguagesElement extends LitElement {
  static override styles = [
    base,
    css`
      :host {
        display: flex;
        gap: 0.5rem;
        align-items: center;
        white-space: nowrap;
      }
      a {
        padding: 0.35rem 0.3rem;
        border-radius: 4px;
        color: var(--accent);
        font-size: 0.875rem;
        text-underline-offset: 0.2em;
      }
    `,
  ];

  @property({ attribute: false }) chosen: Language = 'en';

  override render(): TemplateResult {
    return html`${languages.filter((each) => each !== this.chosen).map((each) => this.link(each))}`;
  }

  private link(language: Language): TemplateResult {
    return html`<a
      lang=${language}
      hreflang=${language}
      href=${addressIn(language)}
      @pointerdown=${(event: PointerEvent) => this.bring(event, language)}
      @click=${(event: MouseEvent) => this.onClick(event, language)}
      >${languageNames[language]}</a
    >`;
  }

  /** Updates the link, because the address may have changed. */
  private bring({ currentTarget }: Event, language: Language): void {
    (currentTarget as HTMLAnchorElement).href = addressIn(language);
  }

  /** In this tab the page switches without a new address; another tab needs the address. */
  private onClick(event: MouseEvent, detail: Language): void {
    if (event.ctrlKey || event.metaKey || event.shiftKey) return;
    event.preventDefault();
    this.dispatchEvent(new CustomEvent<Language>('choose', { detail }));
  }
}

function addressIn(language: Language): string {
  const fields = new URLSearchParams(location.hash.slice(1));
  fields.set('lang', language);
  return `#${fields.toString()}`;
}
