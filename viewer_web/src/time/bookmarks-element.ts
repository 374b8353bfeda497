import { LitElement, css, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property, query, state } from 'lit/decorators.js';
import { repeat } from 'lit/directives/repeat.js';
import type { View } from '../algorithm/view.js';
import { liveKey } from '../base/key-map.js';
import { kbd } from '../elements/keyboard.js';
import { base } from '../elements/theme.js';
import { texts } from '../i18n/index.js';
import type { BookmarkTexts } from '../language/texts.js';
import { isOnDisk } from '../lessons/page-file.js';
import {
  bookmarkAt,
  longestNote,
  mostBookmarks,
  withBookmark,
  withoutBookmark,
} from './bookmarks.js';
import type { Bookmark, Bookmarks } from './bookmarks.js';
import type { Command } from './travel.js';

const bookmarksStyle = css`
  :host {
    display: flex;
    flex-direction: column;
    gap: 0.5rem;
    min-height: 0;
    overflow: auto;
    padding: 0.6rem 0.75rem;
    scrollbar-width: thin;
    font-size: 0.8125rem;
  }
  .head {
    display: flex;
    flex-wrap: wrap;
    gap: 0.25rem 0.6rem;
    align-items: center;
    justify-content: space-between;
  }
  .add {
    padding: 0 0.7rem;
  }
  kbd {
    color: var(--soft);
    font: 0.8125rem var(--mono);
  }
  .count,
  .hint {
    color: var(--soft);
  }
  .limit:not(:empty) {
    padding: 0.4rem 0.6rem;
    border-radius: 6px;
    background: var(--warn-wash);
    color: var(--warn);
  }
  ol {
    display: grid;
    gap: 0.25rem;
    list-style: none;
  }
  li {
    display: grid;
    grid-template-columns: minmax(3.4rem, auto) minmax(0, 1fr) 2rem;
    align-items: start;
    gap: 0.3rem;
    padding: 0.15rem 0.2rem;
    border-radius: 6px;
  }
  .now {
    background: var(--now);
    box-shadow: inset 3px 0 var(--now-edge);
  }
  .go {
    padding: 0 0.4rem;
    text-align: right;
  }
  textarea {
    width: 100%;
    min-height: 2rem;
    padding: 0.3rem 0.45rem;
    border: 1px solid var(--line);
    border-radius: 6px;
    background: var(--well);
    color: inherit;
    font: inherit;
    line-height: 1.35;
    overflow-wrap: anywhere;
    resize: none;
    field-sizing: content;
  }
  textarea::placeholder {
    color: var(--soft);
    opacity: 1;
  }
  .remove {
    padding: 0;
    line-height: 1;
  }
  @container (min-width: 1500px) {
    :host {
      font-size: 0.9375rem;
    }
  }
`;

/** The bookmarks: each has a button to go to its step, a note that can be edited in place, and a button to remove it. */
@customElement('vidno-bookmarks')
export class BookmarksElement extends LitElement {
  static override styles = [base, bookmarksStyle];

  @property({ attribute: false }) view!: View;
  @property({ attribute: false }) bookmarks: Bookmarks = [];
  @property({ type: Boolean }) linked = false;
  /** The limit that was just reached; null for none. */
  @state() private limit: keyof Pick<BookmarkTexts, 'full' | 'long'> | null = null;
  /** The step whose note is to have the focus. */
  private awaited: number | null = null;
  @query('.add') private addButton!: HTMLElement;

  private get texts(): BookmarkTexts {
    return texts[this.view.language].bookmarks;
  }

  private get full(): boolean {
    return this.bookmarks.length >= mostBookmarks;
  }

  /** Bookmarks the current step, unless it has a bookmark, and moves the focus to its note. */
  mark(): void {
    const { step } = this.view;
    const known = bookmarkAt(this.bookmarks, step);
    this.limit = known === null && this.full ? 'full' : null;
    if (known === null && this.limit === null) {
      this.bookmarks = withBookmark(this.bookmarks, step, '');
      this.tell();
    }
    if (this.limit === null) this.awaited = step;
    else this.addButton.focus();
    this.requestUpdate();
  }

  /** The elements around may first draw the bookmarks as they were, so the note may come with a later update. */
  override updated(): void {
    const note = this.awaited === null ? null : this.noteOf(this.awaited);
    if (note === null) return;
    this.awaited = null;
    note.focus();
  }

  /** Moves the focus to the bookmark of the step, or to the next one. */
  async enter(): Promise<void> {
    await this.updateComplete;
    const { bookmarks, view } = this;
    const next = bookmarks.find(({ step }) => step >= view.step) ?? bookmarks.at(-1);
    const button = next && this.renderRoot.querySelector<HTMLElement>(`[data-go="${next.step}"]`);
    (button ?? this.addButton).focus();
  }

  private noteOf(step: number): HTMLElement | null {
    return this.renderRoot.querySelector<HTMLElement>(`[data-note="${step}"]`);
  }

  private change(bookmarks: Bookmarks): void {
    this.limit = null;
    this.bookmarks = bookmarks;
    this.tell();
  }

  private tell(): void {
    this.ask({ do: 'bookmarks', bookmarks: this.bookmarks });
  }

  private ask(command: Command): void {
    this.dispatchEvent(new CustomEvent<Command>('command', { detail: command }));
  }

  override render(): TemplateResult {
    const { bookmarks, texts: say, limit } = this;
    const { step } = this.view;
    const known = bookmarkAt(bookmarks, step) !== null;
    return html`
      <div class="head">
        <button class="add" @click=${() => this.mark()}>
          ${known ? say.edit(step) : say.add(step)} ${kbd('B')}
        </button>
        <span class="count">${say.count(bookmarks.length, mostBookmarks)}</span>
      </div>
      <p class="limit" role="status">${limit === null ? nothing : this.sayLimit(limit)}</p>
      <ol>
        ${repeat(
          bookmarks,
          (bookmark) => bookmark.step,
          (bookmark) => this.entry(bookmark),
        )}
      </ol>
      <p class="hint">${say.hint(liveKey('B'))}</p>
      <p class="hint">${this.lasting()}</p>
    `;
  }

  /** How long bookmarks are kept, and how to share them. */
  private lasting(): string {
    const { texts: say } = this;
    if (!this.linked) return say.unlinked;
    return isOnDisk() ? say.onDisk : say.linked;
  }

  private sayLimit(limit: 'full' | 'long'): string {
    return limit === 'full' ? this.texts.full(mostBookmarks) : this.texts.long(longestNote);
  }

  private entry({ step, note }: Bookmark): TemplateResult {
    const { texts: say } = this;
    const now = step === this.view.step;
    return html`<li class=${now ? 'now' : ''}>
      <button
        class="go number"
        data-go=${step}
        aria-label=${say.goTo(step)}
        aria-current=${now ? 'step' : nothing}
        @click=${() => this.ask({ do: 'seek', step })}
      >
        ${step}
      </button>
      <textarea
        dir="auto"
        rows="2"
        data-note=${step}
        maxlength=${longestNote}
        placeholder=${say.placeholder}
        aria-label=${say.edit(step)}
        .value=${note}
        @input=${this.onInput}
        @change=${(event: Event) => this.onChange(event, step)}
        @keydown=${(event: KeyboardEvent) => this.onKey(event, note)}
      ></textarea>
      <button
        class="remove"
        aria-label=${say.remove(step)}
        title=${say.remove(step)}
        @click=${() => this.drop(step)}
      >
        ✕
      </button>
    </li>`;
  }

  private drop(step: number): void {
    this.change(withoutBookmark(this.bookmarks, step));
    this.addButton.focus();
  }

  private onInput({ target }: Event): void {
    const { value } = target as HTMLTextAreaElement;
    this.limit = value.length >= longestNote ? 'long' : null;
  }

  private onChange({ target }: Event, step: number): void {
    const field = target as HTMLTextAreaElement;
    this.change(withBookmark(this.bookmarks, step, field.value));
    field.value = bookmarkAt(this.bookmarks, step)?.note ?? '';
  }

  /** Enter saves the typed note, and Escape restores the old one. After both, keys control the steps again. */
  private onKey(event: KeyboardEvent, note: string): void {
    if (event.key !== 'Escape' && event.key !== 'Enter') return;
    const field = event.target as HTMLTextAreaElement;
    if (event.key === 'Escape') field.value = note;
    field.blur();
    event.preventDefault();
  }
}
