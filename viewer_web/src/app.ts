import { LitElement, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, query, state } from 'lit/decorators.js';
import { formatAddress, parseAddress } from './address.js';
import { appStyle } from './app.style.js';
import './components/file-drop.js';
import { headerStyle } from './components/header.style.js';
import { Keyboard } from './components/keyboard.js';
import type { Actions } from './components/keyboard.js';
import './components/languages.js';
import './components/lesson-list.js';
import './components/notice.js';
import './components/player.js';
import type { PlayerElement } from './components/player.js';
import { base, tokens } from './components/theme.js';
import { texts } from './i18n/index.js';
import { preferredLanguage } from './i18n/language.js';
import type { Language } from './i18n/language.js';
import { embeddedLessons, idOf } from './lessons.js';
import type { LessonTrace } from './lessons.js';
import type { Act } from './live/editor.js';
import type { Pixel } from './picture/pixel.js';
import { Session } from './session.js';
import { plain } from './setting.js';
import type { Setting } from './setting.js';
import type { Bookmarks } from './time/bookmarks.js';

/** The page: lessons, files of one's own, and the player. */
@customElement('vidno-app')
export class AppElement extends LitElement {
  static override styles = [tokens, base, headerStyle, appStyle];

  @state() private language: Language = 'en';
  @state() private presenting = false;
  @state() private setting: Setting = plain;
  @query('vidno-player') private player!: PlayerElement;

  private readonly lessons = embeddedLessons(document);
  private readonly session = new Session(this, () => {
    this.requestUpdate();
    this.writeAddress();
  });
  private readonly keyboard = new Keyboard(this, () => this.editorActions());
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
    const { language, trace, live, presenting, setting, ...place } = parseAddress(location.hash);
    this.presenting = presenting;
    this.setting = setting;
    this.toggleAttribute('embed', setting.embed);
    this.language = language ?? this.language;
    const { session } = this;
    if (live !== null) {
      void session.openCarried(live, place);
      return;
    }
    const all = this.lessons.flatMap((lesson) => lesson.traces);
    const chosen =
      all.find((each) => idOf(each) === trace) ?? (trace === null ? all[0] : undefined);
    if (chosen === undefined) return;
    if (idOf(chosen) === session.lesson) session.move(place);
    else void session.openLesson(chosen, place);
  };

  /** Keys that were pressed outside the player are passed on to it. */
  private readonly onKey = (event: KeyboardEvent): void => {
    if (this.session.live.handleKey(event)) return;
    this.keyboard.handle(event);
    if (!event.composedPath().includes(this.player)) this.player.handleKey(event);
  };

  /** To the scene and back to the state; to the drawing of a polygon. */
  private editorActions(): Actions {
    const { player } = this;
    const { live } = this.session;
    if (live.editing === null) return {};
    return {
      KeyE: () => (player.side = player.side === 'scene' ? 'state' : 'scene'),
      KeyN: () => {
        player.side = 'scene';
        live.act({ do: 'draw' });
      },
    };
  }

  /** Later, since browsers limit how often an address may change. */
  private writeAddress(): void {
    clearTimeout(this.addressTimer);
    this.addressTimer = window.setTimeout(() => {
      void this.address().then((address) => history.replaceState(null, '', address));
    }, 250);
  }

  private async address(): Promise<string> {
    const { language, presenting, setting, session } = this;
    const live = await session.live.carried();
    const { lesson: trace, place } = session;
    return formatAddress({ language, trace, live, presenting, setting, ...place });
  }

  private async copyLink(): Promise<void> {
    const { live, lesson } = this.session;
    const isHeld = lesson !== null || (await live.carried()) !== null;
    await live.copyLink(isHeld ? new URL(await this.address(), location.href).href : null);
  }

  private present(on: boolean): void {
    this.presenting = on;
    this.writeAddress();
  }

  private chooseLanguage(language: Language): void {
    this.language = language;
    this.writeAddress();
  }

  override updated(): void {
    document.documentElement.lang = this.language;
    document.title = this.session.trace ? `${this.name} · vidno` : 'vidno';
  }

  override render(): TemplateResult {
    const { session, language, setting } = this;
    const { trace, place, live } = session;
    const page = texts[language].page;
    return html`
      <header ?inert=${this.presenting}>
        <h1>vidno</h1>
        <p class="tagline">${page.tagline}</p>
        <div class="tools">
          <button @click=${() => this.player.showKeys()} ?disabled=${trace === null}>
            ${page.keys} <kbd>?</kbd>
          </button>
          <button
            class="present"
            @click=${() => this.player.present(true)}
            ?disabled=${trace === null}
          >
            ${page.present} <kbd>F</kbd>
          </button>
          <vidno-languages
            .chosen=${language}
            @choose=${({ detail }: CustomEvent<Language>) => this.chooseLanguage(detail)}
          ></vidno-languages>
        </div>
      </header>
      <nav ?inert=${this.presenting}>
        <vidno-lesson-list
          .lessons=${this.lessons}
          .chosen=${session.lesson}
          .language=${language}
          @choose=${({ detail }: CustomEvent<LessonTrace>) => session.openLesson(detail)}
        ></vidno-lesson-list>
        <vidno-file-drop
          .texts=${page}
          @file=${({ detail }: CustomEvent<File>) => session.openFile(detail)}
        ></vidno-file-drop>
      </nav>
      <main>
        ${this.heading()}
        <vidno-player
          .trace=${trace}
          .length=${session.steps}
          .step=${place.step}
          .lang=${language}
          ?hidden=${trace === null}
          .pixel=${place.pixel}
          .bookmarks=${place.bookmarks}
          .from=${setting.from}
          .to=${setting.to}
          .speed=${setting.speed}
          ?play=${setting.play}
          .controls=${setting.controls}
          ?presenting=${this.presenting}
          ?linked=${session.isLinked}
          .editing=${live.editing}
          .link=${live.link}
          @vidno-step=${({ detail: step }: CustomEvent<number>) => session.move({ step })}
          @vidno-pixel=${({ detail: pixel }: CustomEvent<Pixel | null>) => session.move({ pixel })}
          @vidno-bookmarks=${({ detail: bookmarks }: CustomEvent<Bookmarks>) => session.move({ bookmarks })}
          @vidno-act=${({ detail }: CustomEvent<Act>) => live.act(detail)}
          @vidno-present=${({ detail }: CustomEvent<boolean>) => this.present(detail)}
          @vidno-save=${() => live.save()}
          @vidno-link=${this.copyLink}
        ></vidno-player>
        ${trace === null ? html`<p class="nothing">${page.nothingOpen}</p>` : nothing}
      </main>
    `;
  }

  private get name(): string {
    const found = this.lessons.find(({ traces }) =>
      traces.some((each) => idOf(each) === this.session.lesson),
    );
    return found?.title[this.language] ?? this.session.name;
  }

  private heading(): TemplateResult {
    const { page } = texts[this.language];
    const { session, name } = this;
    const { trace, notice } = session;
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
        class=${notice?.kind ?? nothing}
        .notice=${notice}
        .language=${this.language}
      ></vidno-notice>
    </div>`;
  }
}
