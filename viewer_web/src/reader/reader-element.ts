import { LitElement, css, html, nothing } from 'lit';
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
import { Fitting } from './fitting.js';
import { opening, printedAnswers, sources } from './frame.js';
import { inlines } from './inlines.js';
import { addressIn, addressOfRun, runOf } from './links.js';
import type { AddressOf } from './links.js';
import { ReadingPlace } from './reading-place.js';
import type { Goal, Reached } from './reading-place.js';
import type { LessonStory, Pin } from './story.js';
import { withoutTerms } from './context.js';
import type { TextContext } from './context.js';

/** The SVG drawings of a lesson, as addresses that images can show. */
class Drawings {
  private readonly addresses = new Map<string, string>();

  addressOf(svg: string): string {
    const address =
      this.addresses.get(svg) ?? URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
    this.addresses.set(svg, address);
    return address;
  }

  /** Releases the addresses of drawings that are no longer shown. */
  forget(): void {
    for (const address of this.addresses.values()) URL.revokeObjectURL(address);
    this.addresses.clear();
  }
}

/** The printed text: A4, lines of 140 mm, with hidden parts shown and buttons left out. */
const readerPrint = css`
  @media print {
    :host {
      display: block;
      overflow: visible;
      border: 0;
    }
    .bar,
    nav.long,
    .anchor {
      display: none;
    }
    .box {
      overflow: visible;
    }
    article {
      max-width: 146mm;
      padding: 0;
      font-size: 11pt;
      line-height: 1.45;
      orphans: 2;
      widows: 2;
    }
    h2 {
      margin-bottom: 8mm;
      font-size: 20pt;
    }
    h3 {
      font-size: 14pt;
    }
    h4 {
      font-size: 11.5pt;
    }
    :is(h2, h3, h4),
    p:has(+ :is(pre, vidno-command, figure, .gallery, .formula, .table, .listing, ul, ol)),
    vidno-command:has(+ pre) {
      break-after: avoid;
    }
    /* Chromium divides a paragraph of three lines, which is too short for both orphans and widows. */
    p.short,
    figure,
    tr,
    .table:not(:has(tbody tr:nth-child(13))),
    pre,
    .formula {
      break-inside: avoid;
    }
    pre {
      font-size: 7pt;
      white-space: pre-wrap;
    }
    .pin,
    .lesson {
      padding: 0;
      margin: 0;
      background: none !important;
      color: inherit;
      text-decoration: none;
    }
    .pin::after {
      content: ' [' attr(data-step) ']';
      color: var(--soft);
      font: 0.72em var(--sans);
      white-space: nowrap;
    }
    .link {
      color: inherit;
    }
    .link::after {
      content: ' (' attr(href) ')';
      font-size: 0.8em;
      overflow-wrap: anywhere;
    }
    .question {
      padding: 0 0 0 4mm;
      border-left-width: 1.5pt;
      border-left-color: var(--line);
      break-inside: avoid;
    }
    .about,
    .question details {
      display: none;
    }
    .answers {
      display: block;
    }
    .answers .number {
      margin: 0.8em 0 0.2em;
      color: var(--soft);
      font: 600 8.5pt var(--sans);
      break-after: avoid;
    }
    .listing ol,
    .frame,
    .sources {
      break-inside: avoid;
    }
    .listing p {
      break-after: avoid;
    }
    .listing :is(p, li) {
      font-size: 8.5pt;
    }
    figure img {
      padding: 0;
      max-height: 190mm;
    }
    .gallery {
      grid-template-columns: repeat(auto-fill, minmax(40mm, 1fr));
    }
  }
`;

/** Formulas in a system font with tables for mathematics; the classes are those of Temml. */
const formulaStyle = css`
  math {
    font-family:
      'Cambria Math', 'STIX Two Math', 'Latin Modern Math', 'Libertinus Math',
      'DejaVu Math TeX Gyre', math;
    font-size-adjust: 0.47; /* as high as the letters of the text, whichever font there is */
    line-height: normal;
    hyphens: none;
  }
  .formula {
    padding: 0.15em 0;
    overflow: auto hidden;
    text-align: center;
  }
  .formula math {
    display: block math;
    margin: 0;
    font-size: calc(1em * var(--fit, 1));
  }
  @media print {
    :is(.formula, .table) {
      --fit: 1 !important;
    }
  }
  .glued {
    white-space: nowrap;
  }
  .tml-right {
    text-align: -webkit-right;
    text-align: right;
  }
  .tml-left {
    text-align: -webkit-left;
    text-align: left;
  }
  mtable.tml-jot > mtr > mtd {
    padding-block: 0.7ex;
  }
`;

/** A textbook's page: lines of 60 to 70 letters where there is room. */
const storyStyle = [
  css`
    article {
      max-width: 36rem;
      margin: 0 auto;
      padding: 1.1rem 1.25rem 2rem;
      font: 1.0625rem / 1.58 var(--serif);
      hyphens: auto;
      hanging-punctuation: first allow-end;
      overflow-wrap: break-word;
      text-wrap: pretty;
    }
    h2,
    h3,
    h4 {
      color: var(--ink);
      font-family: var(--serif);
      font-weight: 600;
      letter-spacing: -0.01em;
      line-height: 1.25;
      hyphens: manual;
      text-wrap: balance;
      scroll-margin-top: 1rem;
    }
    h2 {
      margin-bottom: 1.1rem;
      font-size: 1.625rem;
    }
    h3 {
      margin: 2.1rem 0 0.6rem;
      font-size: 1.25rem;
    }
    h4 {
      margin: 1.6rem 0 0.4rem;
      font-size: 1.0625rem;
    }
    :is(h3, h4):focus {
      outline: none;
    }
    .anchor {
      padding: 0 0.2em;
      color: var(--soft);
      font-weight: 400;
      text-decoration: none;
      opacity: 0;
    }
    :is(h3, h4):hover .anchor,
    .anchor:focus-visible {
      opacity: 1;
    }
    p,
    ul,
    ol,
    blockquote,
    figure,
    pre,
    .formula,
    .table,
    vidno-command {
      margin: 0 0 0.85em;
    }
    :is(ul, ol) {
      padding-left: 1.5em;
    }
    li {
      margin-bottom: 0.3em;
    }
    li > p {
      margin-bottom: 0.3em;
    }
    blockquote {
      padding-left: 1em;
      border-left: 3px solid var(--line);
      color: var(--soft);
    }
    code,
    pre {
      font-family: var(--mono);
      font-size: 0.84em;
      hyphens: none;
    }
    pre {
      padding: 0.7rem 0.85rem;
      overflow: auto;
      border: 1px solid var(--line);
      border-radius: 6px;
      background: var(--well);
      font-size: 0.8125rem;
      line-height: 1.5;
    }
    pre code {
      font-size: 1em;
    }
    a {
      color: var(--accent);
      text-decoration-thickness: 1px;
      text-underline-offset: 0.18em;
    }
    .pin {
      padding: 0.06em 0.14em;
      margin: 0 -0.14em;
      border-radius: 4px;
      text-decoration: underline dotted;
      text-decoration-thickness: 1.5px;
      box-decoration-break: clone;
      -webkit-box-decoration-break: clone;
    }
    .pin:hover {
      background: var(--accent-wash);
    }
    .pin[aria-current] {
      background: var(--now);
      color: var(--ink);
      text-decoration-color: var(--now-edge);
      text-decoration-style: solid;
    }
    figure img {
      display: block;
      max-width: 100%;
      margin: 0 auto 0.6rem;
      padding: 0.4rem;
      border-radius: 4px;
      background: #ffffff;
    }
    .gallery {
      display: grid;
      grid-template-columns: repeat(auto-fill, minmax(7.5rem, 1fr));
      gap: 0 1rem;
    }
    /* Many small figures: the commands would be longer than the captions. */
    .gallery:has(> figure:nth-child(3)) vidno-command {
      display: none;
    }
    figcaption {
      color: var(--soft);
      font-size: 0.875em;
      line-height: 1.45;
    }
    .table {
      overflow-x: auto;
    }
    table {
      margin: 0 auto;
      border-block: 1.5px solid var(--soft);
      font-size: calc(0.875em * var(--fit, 1));
      line-height: 1.4;
      font-variant-numeric: lining-nums tabular-nums;
    }
    th {
      border-bottom: 1px solid var(--soft);
      font-weight: 600;
      vertical-align: bottom;
    }
    :is(th, td) {
      padding: 0.3em 0.6em;
      text-align: left;
      hyphens: manual;
    }
    td {
      vertical-align: top;
    }
    :is(th, td).right {
      text-align: right;
    }
    :is(th, td).center {
      text-align: center;
    }
    .about {
      margin: -0.5rem 0 0.7rem;
    }
    .about[open] {
      margin-bottom: 0.3rem;
    }
    @media not print {
      .about:not([open]) + .frame {
        display: none;
      }
    }
    .frame {
      margin: 0 0 1.5em;
      padding: 0.8rem 1rem 0.4rem;
      border: 1px solid var(--line);
      border-radius: 6px;
      font: 0.875rem / 1.5 var(--sans);
    }
    .frame dl {
      margin: 0 0 0.4rem;
    }
    .frame dl > div {
      margin: 0 0 0.2rem;
    }
    .frame :is(dt, .label) {
      color: var(--soft);
      font-weight: 600;
    }
    .frame :is(dt, dd, dd ul, dd li) {
      display: inline;
      margin: 0 0.4em 0 0;
      padding: 0;
    }
    .frame dd li + li::before {
      content: '· ';
    }
    /* Rows of targets need 24 pixels each. */
    .frame .term {
      display: inline-block;
      line-height: 1.75;
    }
    .frame .label {
      margin-bottom: 0.2rem;
    }
    .frame ul {
      margin: 0;
      padding-left: 1.2em;
    }
    .frame li {
      margin: 0 0 0.15em;
    }
    .listing {
      margin: 0 0 1.1em;
      padding: 0.5rem 0;
      border-block: 1px solid var(--line);
      hyphens: none;
      text-wrap: wrap;
    }
    .listing p {
      margin: 0.35rem 0 0.2rem;
      font: 0.8125rem / 1.4 var(--mono);
    }
    .listing .title {
      margin-left: 0.4em;
      color: var(--soft);
      font: 0.75rem var(--sans);
    }
    .listing ol {
      margin: 0 0 0.4rem;
      padding: 0;
      list-style: none;
    }
    .listing li {
      display: grid;
      grid-template-columns: 2.5rem 1fr auto;
      align-items: baseline;
      margin: 0;
      padding: 0.1rem 0;
      font: 0.8125rem / 1.4 var(--sans);
    }
    .listing .at {
      color: var(--soft);
      font: 0.6875rem var(--mono);
    }
    .listing code {
      padding-left: calc(var(--indent) * 1rem + 0.8rem);
      text-indent: -0.8rem;
      font: inherit;
      overflow-wrap: anywhere;
    }
    .listing .defects {
      padding-left: 0.6rem;
      color: var(--bad);
      font: 0.6875rem var(--mono);
    }
    .sources {
      font-size: 0.9em;
    }
    .answers {
      display: none;
    }
    .question {
      margin: 0 0 1.1em;
      padding: 0.8rem 1rem;
      border-left: 3px solid var(--accent);
      border-radius: 0 6px 6px 0;
      background: var(--well);
    }
    .question .number {
      margin-bottom: 0.25rem;
      color: var(--soft);
      font: 600 0.75rem var(--sans);
      letter-spacing: 0.02em;
    }
    .question > :nth-last-child(2) {
      margin-bottom: 0.4rem;
    }
    summary {
      width: fit-content;
      padding: 0.1rem 0.4rem 0.1rem 0;
      border-radius: 4px;
      color: var(--accent);
      font: 0.875rem / 1.75rem var(--sans);
      cursor: pointer;
    }
    .answer {
      padding-top: 0.35rem;
    }
    .answer > :last-child {
      margin-bottom: 0.2rem;
    }
    @media (max-width: 1199px) {
      article {
        padding-inline: 1.25rem;
      }
    }
  `,
  formulaStyle,
];

/** The text of a lesson in a scrolling box, and the line above it. */
const readerStyle = [
  storyStyle,
  css`
    :host {
      display: flex;
      flex-direction: column;
      min-width: 0;
      min-height: 0;
      overflow: hidden;
      border: 1px solid var(--line);
      border-radius: var(--radius);
      background: var(--panel);
      --serif:
        'Iowan Old Style', Charter, 'Source Serif 4', Cambria, 'PT Serif', 'Noto Serif', Georgia,
        'Liberation Serif', 'DejaVu Serif', serif;
    }
    .bar {
      display: flex;
      flex: none;
      gap: 0.75rem;
      align-items: center;
      min-height: 2.1rem;
      padding: 0 0.5rem 0 0.9rem;
      border-bottom: 1px solid var(--line);
      color: var(--soft);
      font-size: 0.8125rem;
    }
    .bar select {
      min-width: 0;
      min-height: 1.6rem;
      margin-left: -0.4rem;
      border-color: transparent;
      background: none;
      text-overflow: ellipsis;
    }
    .bar select:hover {
      border-color: var(--line);
    }
    nav.short {
      display: flex;
      flex: none;
      gap: 0.15rem;
      margin-left: auto;
    }
    nav.short a {
      min-width: 1.75rem;
      border-radius: 5px;
      color: var(--soft);
      line-height: 1.75rem;
      text-align: center;
      text-decoration: none;
    }
    nav.short a:hover {
      background: var(--accent-wash);
      color: var(--ink);
    }
    .box {
      flex: 1;
      min-height: 0;
      overflow: auto;
      overflow-anchor: none;
      overscroll-behavior: contain;
      scrollbar-width: thin;
    }
    .box:focus-visible {
      outline-offset: -3px;
    }
    nav.long {
      display: flex;
      gap: 1rem;
      justify-content: space-between;
      margin-top: 2.5rem;
      padding-top: 1rem;
      border-top: 1px solid var(--line);
      font: 0.875rem / 1.4 var(--sans);
    }
    nav.long a {
      display: grid;
      text-decoration: none;
    }
    nav.long a:hover {
      text-decoration: underline;
    }
    nav.long small {
      color: var(--soft);
      font-size: 0.75rem;
    }
    nav.long .next {
      margin-left: auto;
      text-align: right;
    }
    .refused {
      padding: 0.6rem 0.8rem;
      border-radius: 6px;
      background: var(--bad-wash);
      color: var(--bad);
      font: 0.9375rem / 1.45 var(--sans);
    }
    /* The page itself may scroll. */
    @media (max-width: 899px) {
      .box {
        overscroll-behavior: auto;
      }
      .bar {
        display: none;
      }
    }
  `,
  readerPrint,
];

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
        ${this.story === null ? this.excuse() : keyed(this.story.id, this.textOf(this.story))}
      </div>
    `;
  }

  private textOf(lesson: LessonStory): TemplateResult {
    const { language, addressOf, current } = this;
    const { reader, page } = texts[language];
    const story = lesson.story[language];
    const context: TextContext = {
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
      <h2>${inlines(story.title, withoutTerms(context))}</h2>
      ${opening(context, language)} ${blocks(story.blocks, context)} ${sources(context, language)}
      ${printedAnswers(context)} ${this.neighbours('long')}
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
    const withText = lessons.filter((lesson) => lesson.story !== undefined);
    const runs = withText.find(({ id }) => id === story?.id)?.traces ?? [];
    if (story === null || withText.length + runs.length <= 2) return nothing;
    const { page, reader } = texts[language];
    return html`<select
      aria-label=${page.lessons}
      .value=${live(story.id)}
      @change=${this.onChoose}
    >
      <optgroup label=${page.lessons}>
        ${withText.map(
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
