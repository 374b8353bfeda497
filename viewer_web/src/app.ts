import { LitElement, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, query, state } from 'lit/decorators.js';
import { formatAddress, parseAddress } from './address.js';
import type { Address } from './address.js';
import { appStyle } from './app.style.js';
import './components/file-drop.js';
import { headerStyle } from './components/header.style.js';
import './components/languages.js';
import './components/lesson-list.js';
import './components/notice.js';
import type { Notice } from './components/notice.js';
import './components/player.js';
import type { PlayerElement } from './components/player.js';
import { base, tokens } from './components/theme.js';
import { texts } from './i18n/index.js';
import { preferredLanguage } from './i18n/language.js';
import type { Language } from './i18n/language.js';
import { embeddedFile, embeddedLessons, idOf } from './lessons.js';
import type { LessonTrace } from './lessons.js';
import type { Pixel } from './picture/pixel.js';
import type { Bookmarks } from './time/bookmarks.js';
import { openTrace } from './trace/open.js';
import type { Trace } from './trace/trace.js';

/** Where in a trace the page is, and what is marked in it. */
type Place = Pick<Address, 'step' | 'pixel' | 'bookmarks'>;
const beginning: Place = { step: 0, pixel: null, bookmarks: [] };

/** What is to be said about a trace that is shown. */
function noticeOf(trace: Trace): Notice | null {
  const { complete, shortened, timeline, read } = trace;
  if (!complete) return { kind: 'growing', steps: timeline.length, read };
  return shortened && { kind: 'shortened', ...shortened };
}

/** The page: lessons, files of one's own, and the player. */
@customElement('vidno-app')
export class AppElement extends LitElement {
  static override styles = [tokens, base, headerStyle, appStyle];

  @state() private language: Language = 'en';
  @state() private trace: Trace | null = null;
  /** How many of its steps are there. */
  @state() private steps = 0;
  @state() private traceName = '';
  @state() private lesson: string | null = null;
  @state() private place = beginning;
  @state() private notice: Notice | null = null;
  @query('vidno-player') private player!: PlayerElement;

  private readonly lessons = embeddedLessons(document);
  private stopReading = (): void => undefined;
  private addressTimer = 0;

  override connectedCallback(): void {
    super.connectedCallback();
    this.language = preferredLanguage();
    this.followAddress();
    window.addEventListener('hashchange', this.followAddress);
    window.addEventListener('keydown', this.onKey);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    window.removeEventListener('hashchange', this.followAddress);
    window.removeEventListener('keydown', this.onKey);
  }

  private readonly followAddress = (): void => {
    const { language, trace, ...place } = parseAddress(location.hash);
    this.language = language ?? this.language;
    const all = this.lessons.flatMap((lesson) => lesson.traces);
    const chosen =
      all.find((each) => idOf(each) === trace) ?? (trace === null ? all[0] : undefined);
    if (chosen === undefined) return;
    if (idOf(chosen) === this.lesson) this.place = place;
    else this.openLesson(chosen, place);
  };

  private openLesson(chosen: LessonTrace, place = beginning): void {
    const file = embeddedFile(document, chosen);
    if (file !== null) this.open(file, chosen.file, idOf(chosen), place);
  }

  private open(file: Blob, name: string, lesson: string | null, place = beginning): void {
    this.stopReading();
    this.notice = { kind: 'reading', name };
    this.stopReading = openTrace(file, {
      grown: (trace) => {
        if (this.trace === trace) this.steps = trace.timeline.length;
        else if (trace.complete || trace.timeline.length >= place.step) {
          this.show(trace, name, lesson, place);
        }
        if (this.trace === trace) this.notice = noticeOf(trace);
      },
      failed: (error) => {
        if (this.trace?.complete === false) this.trace = null;
        this.notice = { kind: 'failed', name, error };
      },
    });
  }

  private show(trace: Trace, name: string, lesson: string | null, place: Place): void {
    this.trace = trace;
    this.steps = trace.timeline.length;
    this.traceName = name;
    this.lesson = lesson;
    this.place = place;
    this.writeAddress();
  }

  private readonly onKey = (event: KeyboardEvent): void => {
    if (!event.composedPath().includes(this.player)) this.player.handleKey(event);
  };

  private onStep({ detail: step }: CustomEvent<number>): void {
    this.move({ step });
  }

  private onPixel({ detail: pixel }: CustomEvent<Pixel | null>): void {
    this.move({ pixel });
  }

  private onBookmarks({ detail: bookmarks }: CustomEvent<Bookmarks>): void {
    this.move({ bookmarks });
  }

  private move(change: Partial<Place>): void {
    this.place = { ...this.place, ...change };
    this.writeAddress();
  }

  /** Later, since browsers limit how often an address may change. */
  private writeAddress(): void {
    clearTimeout(this.addressTimer);
    this.addressTimer = window.setTimeout(() => {
      const { language, lesson: trace, place } = this;
      history.replaceState(null, '', formatAddress({ language, trace, ...place }));
    }, 250);
  }

  private chooseLanguage(language: Language): void {
    this.language = language;
    this.writeAddress();
  }

  override updated(): void {
    document.documentElement.lang = this.language;
    document.title = this.trace ? `${this.name} · vidno` : 'vidno';
  }

  override render(): TemplateResult {
    const page = texts[this.language].page;
    return html`
      <header>
        <h1>vidno</h1>
        <p class="tagline">${page.tagline}</p>
        <div class="tools">
          <button @click=${() => this.player.showKeys()} ?disabled=${this.trace === null}>
            ${page.keys} <kbd>?</kbd>
          </button>
          <vidno-languages
            .chosen=${this.language}
            @choose=${({ detail }: CustomEvent<Language>) => this.chooseLanguage(detail)}
          ></vidno-languages>
        </div>
      </header>
      <nav>
        <vidno-lesson-list
          .lessons=${this.lessons}
          .chosen=${this.lesson}
          .language=${this.language}
          @choose=${({ detail }: CustomEvent<LessonTrace>) => this.openLesson(detail)}
        ></vidno-lesson-list>
        <vidno-file-drop
          .texts=${page}
          @file=${({ detail }: CustomEvent<File>) => this.open(detail, detail.name, null)}
        ></vidno-file-drop>
      </nav>
      <main>
        ${this.heading()}
        <vidno-player
          .trace=${this.trace}
          .length=${this.steps}
          .step=${this.place.step}
          .lang=${this.language}
          ?hidden=${this.trace === null}
          .pixel=${this.place.pixel}
          .bookmarks=${this.place.bookmarks}
          ?linked=${this.lesson !== null}
          @vidno-step=${this.onStep}
          @vidno-pixel=${this.onPixel}
          @vidno-bookmarks=${this.onBookmarks}
        ></vidno-player>
        ${this.trace === null ? html`<p class="nothing">${page.nothingOpen}</p>` : nothing}
      </main>
    `;
  }

  private get name(): string {
    const found = this.lessons.find(({ traces }) =>
      traces.some((each) => idOf(each) === this.lesson),
    );
    return found?.title[this.language] ?? this.traceName;
  }

  private heading(): TemplateResult {
    const { page } = texts[this.language];
    const { trace, name } = this;
    const header = trace?.header;
    return html`<div class="title">
      <h2>${trace ? name : ''}</h2>
      ${
        header
          ? html`<p>
              ${page.methods[header.method]} · ${page.editions[header.edition]} · ${page.kernel}:
              ${header.kernel} · ${page.detail}: ${header.detail}
            </p>`
          : nothing
      }
      <vidno-notice
        class=${this.notice?.kind ?? nothing}
        .notice=${this.notice}
        .language=${this.language}
      ></vidno-notice>
    </div>`;
  }
}
