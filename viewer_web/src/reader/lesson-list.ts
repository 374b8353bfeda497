import { LitElement, css, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import type { Setup } from './address.js';
import { texts } from '../i18n/index.js';
import type { Language } from '../language/language.js';
import { Follower } from '../picture/in-sight.js';
import { idOf } from '../lessons/lessons.js';
import type { Lesson, LessonTrace } from '../lessons/lessons.js';
import { addressIn } from './links.js';
import { inlines } from './inlines.js';
import type { Heading, Story } from './story.js';
import { runName } from '../lessons/run-name.js';
import { base } from '../elements/theme.js';

/** The program and its version, as the page's head states it. */
const generator = (): string =>
  document.querySelector<HTMLMetaElement>('meta[name=generator]')?.content ?? '';

/**
 * The lessons in the page: those without a text with their traces, the current one also with its headings. Events carry
 * requests: `choose` a trace, `visit` a heading, `leave` for anything in the text, and `follow` to set whether the run
 * follows the text.
 */
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
      a {
        display: block;
        color: inherit;
        text-decoration: none;
      }
      a:hover {
        color: var(--accent);
        text-decoration: underline;
      }
      h3:has(a) {
        font-weight: 500;
      }
      h3 a[aria-current] {
        color: var(--accent);
        font-weight: 650;
      }
      ul {
        margin: 0 0 0.5rem;
        list-style: none;
      }
      ul li,
      ul li + li {
        padding: 0;
        border: 0;
        font-size: 0.8125rem;
        line-height: 1.35;
      }
      ul a {
        min-height: 1.5rem;
        padding: 0.2rem 0 0.2rem 0.6rem;
        border-left: 2px solid var(--line);
        color: var(--soft);
      }
      .level3 a {
        padding-left: 1.3rem;
      }
      ul a[aria-current] {
        border-left-color: var(--accent);
        color: var(--ink);
        font-weight: 600;
      }
      .traces {
        display: flex;
        flex-direction: column;
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
        display: block;
        opacity: 0.8;
        font-size: 0.75rem;
      }
      p {
        padding: 0 0.4rem;
        color: var(--soft);
        font-size: 0.875rem;
      }
      .version {
        padding-top: 0.4rem;
        font-size: 0.75rem;
      }
      .follow {
        display: flex;
        gap: 0.4rem;
        align-items: center;
        min-height: 1.75rem;
        margin-bottom: 0.4rem;
        color: var(--soft);
        font-size: 0.8125rem;
      }
      .follow input {
        margin: 0;
        accent-color: var(--accent);
      }
    `,
  ];

  @property({ attribute: false }) lessons: readonly Lesson[] = [];
  @property({ attribute: false }) chosen: string | null = null;
  @property({ attribute: false }) setup!: Setup;
  /** The current lesson, its text if it is read, and the current heading. */
  @property({ attribute: false }) read: string | null = null;
  @property({ attribute: false }) story: Story | null = null;
  @property({ attribute: false }) heading: string | null = null;

  /** Scrolls the contents to the current lesson, never the page. */
  private readonly follower = new Follower();

  override updated(): void {
    const current = this.renderRoot.querySelector('[aria-current=page]')?.closest('li') ?? null;
    this.follower.follow(this.closest('nav'), current);
  }

  override render(): TemplateResult {
    const { page } = texts[this.language];
    return html`
      <h2>${page.lessons}</h2>
      ${this.lessons.length === 0 ? html`<p>${page.noLessons}</p>` : nothing}
      <ol>
        ${this.lessons.map((lesson) => this.lesson(lesson))}
      </ol>
      <p class="version">${generator()}</p>
    `;
  }

  private get language(): Language {
    return this.setup.language;
  }

  private addressOf(lesson: string, place?: string): string | typeof nothing {
    return addressIn(this.lessons, this.setup)(lesson, place) ?? nothing;
  }

  private lesson({ id, title, traces, story }: Lesson): TemplateResult {
    const name = title[this.language];
    const isRead = story !== undefined && id === this.read;
    return html`<li>
      <h3>
        ${
          story === undefined
            ? name
            : html`<a
                href=${this.addressOf(id)}
                aria-current=${isRead ? 'page' : nothing}
                @click=${() => this.dispatchEvent(new CustomEvent('leave'))}
                >${name}</a
              >`
        }
      </h3>
      ${isRead ? this.contents() : nothing}
      ${
        isRead || story === undefined
          ? html`<div class="traces">${traces.map((trace) => this.trace(trace))}</div>`
          : nothing
      }
    </li>`;
  }

  /** The headings of the current lesson. */
  private contents(): TemplateResult {
    const marks = [...(this.story?.places ?? [])];
    const { reader } = texts[this.language];
    const { follows } = this.setup;
    return html`<label class="follow" title=${reader.followHint}>
        <input
          type="checkbox"
          .checked=${follows}
          @change=${() => this.dispatchEvent(new CustomEvent('follow', { detail: !follows }))}
        />
        ${reader.follow}
      </label>
      <ul>
        ${marks.map(([mark, place]) => (mark.is === 'heading' ? this.headline(mark, place) : nothing))}
      </ul>`;
  }

  private headline({ level, text }: Heading, place: string): TemplateResult {
    return html`<li class="level${level}">
      <a
        href=${this.addressOf(this.read ?? '', place)}
        aria-current=${place === this.heading ? 'location' : nothing}
        @click=${(event: MouseEvent) => this.visit(event, place)}
        >${inlines(text, null)}</a
      >
    </li>`;
  }

  private visit(event: MouseEvent, place: string): void {
    if (event.ctrlKey || event.metaKey || event.shiftKey) return;
    event.preventDefault();
    this.dispatchEvent(new CustomEvent('visit', { detail: place }));
    this.dispatchEvent(new CustomEvent('leave'));
  }

  private trace(trace: LessonTrace): TemplateResult {
    const { title, way } = runName(trace, texts[this.language].page, this.language);
    return html`<button
      aria-pressed=${idOf(trace) === this.chosen ? 'true' : 'false'}
      data-trace=${idOf(trace)}
      @click=${() => this.dispatchEvent(new CustomEvent('choose', { detail: trace }))}
    >
      ${title} ${way === title ? nothing : html`<small>${way}</small>`}
    </button>`;
  }
}
