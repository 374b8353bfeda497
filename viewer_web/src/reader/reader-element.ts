import { LitElement, html, nothing } from 'lit';
import type { PropertyValues, TemplateResult } from 'lit';
import { customElement, property, query } from 'lit/decorators.js';
import { keyed } from 'lit/directives/keyed.js';
import { live } from 'lit/directives/live.js';
import { base } from '../elements/theme.js';
import { FirstTerms } from '../i18n/glossary.js';
import { texts } from '../i18n/index.js';
import type { Language } from '../language/language.js';
import { idOf } from '../lessons/lessons.js';
import type { Lesson } from '../lessons/lessons.js';
import { runLabel } from '../lessons/run-name.js';
import { isRefusal } from '../trace/refusal.js';
import type { Setup } from './address.js';
import { blocks } from './blocks.js';
import { Drawings } from './drawings.js';
import { Fitting } from './fitting.js';
import { opening, printedAnswers, sources } from './frame.js';
import { inlines } from './inlines.js';
import { addressIn, addressOfRun, runOf } from './links.js';
import type { AddressOf } from './links.js';
import { readerStyle } from './reader.style.js';
import { ReadingPlace } from './reading-place.js';
import type { Goal, Reached } from './reading-place.js';
import type { LessonStory, Pin } from './story.js';
import { withoutTerms } from './telling.js';
import type { Telling } from './telling.js';

/** The reader's place in the text, and whether it was reached by scrolling. */
export type Read = Reached & { readonly isScrolled: boolean };

/**
 * The text of a lesson. An event `read` reports that the reader has come to another place; `pin` asks for a pin by the name
 * of its place. The slot is the first line of the text.
 */
@customElement('vidno-reader')
export class ReaderElement extends LitElement {
  static override styles = [base, readerStyle];

  @property({ attribute: false }) story: LessonStory | null = null;
  /** Why there is no text. */
  @property({ attribute: false }) error: unknown = null;
  @property({ attribute: false }) lessons: readonly Lesson[] = [];
  @property({ attribute: false }) setup!: Setup;
  /** The place to scroll to. */
  @property({ attribute: false }) goal: Goal = { place: null, isRead: false };
  /** The name of the place of the current pin. */
  @property({ attribute: false }) current: string | null = null;
  @property({ attribute: false }) previous: Lesson | null = null;
  @property({ attribute: false }) next: Lesson | null = null;
  @query('.box') readonly box!: HTMLElement;
  @query('article') readonly article!: HTMLElement;

  private readonly drawings = new Drawings();
  // This comes before the search for the place, because shrinking elements moves places.
  private readonly fitting = new Fitting(() => this.article);
  private readonly place = new ReadingPlace(this);
  /** Whether the reader chose a lesson from the list, which is absent while the lesson loads. */
  private isChoosing = false;

  private get language(): Language {
    return this.setup.language;
  }

  private get addressOf(): AddressOf {
    return addressIn(this.lessons, this.setup);
  }

  override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has('story')) this.drawings.forget();
  }

  override firstUpdated(): void {
    this.fitting.watch(this.box);
    this.place.watch();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.fitting.stop();
  }

  override updated(changed: PropertyValues<this>): void {
    if (changed.has('story') || changed.has('setup')) this.fitting.fit();
    if (changed.has('story') && this.story !== null && this.isChoosing) {
      this.isChoosing = false;
      this.renderRoot.querySelector('select')?.focus();
    }
    if (changed.has('story') || changed.has('goal')) void this.show();
    else if (changed.has('setup')) this.place.restore();
  }

  /** Scrolls after the parts are rendered, when their positions are known. */
  private async show(): Promise<void> {
    const commands = [...this.article.querySelectorAll('vidno-command')];
    await Promise.all(commands.map(({ updateComplete }) => updateComplete));
    this.place.show(this.goal);
  }

  reached(now: Reached, isScrolled: boolean): void {
    this.dispatchEvent(new CustomEvent('read', { detail: { ...now, isScrolled } }));
  }

  override render(): TemplateResult {
    const { reader } = texts[this.language];
    return html`
      <div class="bar">${this.choice()} ${this.neighbours('short')}</div>
      <div class="box" tabindex="0" role="region" aria-label=${reader.text} @click=${this.onClick}>
        <slot></slot>
        ${this.story === null ? this.excuse() : keyed(this.story.id, this.told(this.story))}
      </div>
    `;
  }

  private told(lesson: LessonStory): TemplateResult {
    const { language, addressOf, current } = this;
    const { reader, page } = texts[language];
    const story = lesson.story[language];
    const telling: Telling = {
      lesson,
      texts: reader,
      story,
      current,
      terms: new FirstTerms(language),
      addressOf,
      runOf: (pin: Pin) => runOf(pin, lesson, this.lessons, page, language),
      drawingOf: (svg: string) => this.drawings.addressOf(svg),
      language,
    };
    return html`<article lang=${language}>
      <h2>${inlines(story.title, withoutTerms(telling))}</h2>
      ${opening(telling, language)} ${blocks(story.blocks, telling)} ${sources(telling, language)}
      ${printedAnswers(telling)} ${this.neighbours('long')}
    </article>`;
  }

  private excuse(): TemplateResult {
    const { reader, reasons } = texts[this.language];
    const { error } = this;
    if (error === null) return html`<article></article>`;
    const say: ((...details: string[]) => string) | null = isRefusal(error)
      ? reasons[error.reason]
      : null;
    return html`<article>
      <p class="refused" role="alert">
        ${isRefusal(error) && say ? reader.refused(error.path, say(...error.details)) : reader.broken}
      </p>
    </article>`;
  }

  /** The choice of a lesson among those that have a text, and of a run of the current lesson. */
  private choice(): TemplateResult | typeof nothing {
    const { language, lessons, story } = this;
    const told = lessons.filter((lesson) => lesson.story !== undefined);
    const runs = told.find(({ id }) => id === story?.id)?.traces ?? [];
    if (story === null || told.length + runs.length <= 2) return nothing;
    const { page, reader } = texts[language];
    return html`<select
      aria-label=${page.lessons}
      .value=${live(story.id)}
      @change=${this.onChoose}
    >
      <optgroup label=${page.lessons}>
        ${told.map(
          ({ id, title }) =>
            html`<option value=${id} ?selected=${id === story.id}>${title[language]}</option>`,
        )}
      </optgroup>
      <optgroup label=${reader.runs}>
        ${runs.map(
          (run) => html`<option value=${idOf(run)}>${runLabel(run, page, language)}</option>`,
        )}
      </optgroup>
    </select>`;
  }

  private onChoose({ target }: Event): void {
    const { value } = target as HTMLSelectElement;
    const isRun = !this.lessons.some(({ id }) => id === value);
    const address = isRun
      ? addressOfRun(this.story?.id ?? null, value, this.setup)
      : this.addressOf(value);
    if (address === null) return;
    this.isChoosing = !isRun;
    location.hash = address;
    // The choice shows the old lesson until the new one is read, and if the reader stays.
    this.requestUpdate();
  }

  /** Links to the previous and the next lesson. */
  private neighbours(form: 'short' | 'long'): TemplateResult {
    const { reader } = texts[this.language];
    const way = (lesson: Lesson | null, name: string, sign: string, where: string): unknown => {
      if (lesson === null) return nothing;
      const address = this.addressOf(lesson.id) ?? nothing;
      const title = lesson.title[this.language];
      return form === 'short'
        ? html`<a href=${address} aria-label="${name}: ${title}" title=${title}>${sign}</a>`
        : html`<a href=${address} class=${where}><small>${name}</small> ${title}</a>`;
    };
    return html`<nav class=${form} aria-label=${form === 'long' ? reader.otherLessons : nothing}>
      ${way(this.previous, reader.previous, '←', 'previous')}
      ${way(this.next, reader.next, '→', 'next')}
    </nav>`;
  }

  /** Goes to a pin at once. With a modifier key for a new window, the browser opens its address as usual. */
  private onClick(event: MouseEvent): void {
    const pin = event
      .composedPath()
      .find((each): each is HTMLAnchorElement => each instanceof HTMLAnchorElement);
    const place = pin?.dataset['place'];
    if (place === undefined || event.ctrlKey || event.metaKey || event.shiftKey) return;
    event.preventDefault();
    this.dispatchEvent(new CustomEvent('pin', { detail: place }));
  }
}
