import { LitElement, css, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { texts } from '../i18n/index.js';
import type { Language } from '../i18n/language.js';
import { idOf } from '../lessons.js';
import type { Lesson, LessonTrace } from '../lessons.js';
import { base } from './theme.js';

/** The lessons that came with the page, each with its traces. */
@customElement('vidno-lesson-list')
export class LessonListElement extends LitElement {
  static override styles = [
    base,
    css`
      :host {
        display: block;
        overflow: auto;
        border: 1px solid var(--line);
        border-radius: var(--radius);
        background: var(--panel);
        padding: 0.6rem 0.5rem;
        scrollbar-width: thin;
      }
      h2 {
        padding: 0 0.4rem 0.3rem;
      }
      ol {
        list-style: none;
      }
      li {
        padding: 0.35rem 0.4rem 0.45rem;
      }
      li + li {
        border-top: 1px solid var(--line);
      }
      h3 {
        color: var(--ink);
        font-size: 0.875rem;
        letter-spacing: 0;
        margin-bottom: 0.3rem;
      }
      .traces {
        display: flex;
        flex-wrap: wrap;
        gap: 0.3rem;
      }
      button {
        min-height: 1.75rem;
        padding: 0 0.55rem;
        font-size: 0.8125rem;
        text-align: left;
      }
      button[aria-pressed='true'] {
        background: var(--accent);
        border-color: var(--accent);
        color: var(--on-accent);
      }
      small {
        font-size: 0.75rem;
      }
      p {
        padding: 0 0.4rem;
        color: var(--soft);
        font-size: 0.875rem;
      }
      @media (max-width: 1199px) {
        :host {
          max-height: 9.5rem;
        }
      }
    `,
  ];

  @property({ attribute: false }) lessons: readonly Lesson[] = [];
  @property({ attribute: false }) chosen: string | null = null;
  @property({ attribute: false }) language: Language = 'en';

  override render(): TemplateResult {
    const { page } = texts[this.language];
    return html`
      <h2>${page.lessons}</h2>
      ${this.lessons.length === 0 ? html`<p>${page.noLessons}</p>` : nothing}
      <ol>
        ${this.lessons.map(
          ({ title, traces }) =>
            html`<li>
              <h3>${title[this.language]}</h3>
              <div class="traces">${traces.map((trace) => this.trace(trace))}</div>
            </li>`,
        )}
      </ol>
    `;
  }

  private trace(trace: LessonTrace): TemplateResult {
    const { page } = texts[this.language];
    const { method, kernel, edition } = trace;
    const variant = [
      ...(edition === 'corrected' ? [] : [page.editions[edition]]),
      ...(kernel === 'double' ? [] : [kernel]),
    ].join(', ');
    return html`<button
      aria-pressed=${idOf(trace) === this.chosen ? 'true' : 'false'}
      data-trace=${idOf(trace)}
      @click=${() => this.dispatchEvent(new CustomEvent('choose', { detail: trace }))}
    >
      ${page.methods[method]} ${variant === '' ? nothing : html`<small>${variant}</small>`}
    </button>`;
  }
}
