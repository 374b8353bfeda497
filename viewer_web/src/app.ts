import { LitElement, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, query, state } from 'lit/decorators.js';
import { formatAddress, parseAddress } from './address.js';
import type { Setup } from './address.js';
import { appStyle } from './app.style.js';
import './components/file-drop.js';
import { Keyboard } from './components/keyboard.js';
import type { Actions } from './components/keyboard.js';
import './components/lesson-list.js';
import './components/notice.js';
import './components/page-header.js';
import './components/player.js';
import type { PlayerElement } from './components/player.js';
import './components/solid.js';
import { base, tokens } from './components/theme.js';
import { texts } from './i18n/index.js';
import { preferredLanguage } from './i18n/language.js';
import type { Language } from './i18n/language.js';
import { embeddedLessons, idOf } from './lessons.js';
import type { LessonTrace } from './lessons.js';
import type { Act } from './live/editor.js';
import { needsExact } from './picture/layers.js';
import type { Exact, Layer } from './picture/layers.js';
import type { Pixel } from './picture/pixel.js';
import { Session } from './session.js';
import { plain } from './setting.js';
import type { Way } from './setting.js';
import type { Bookmarks } from './time/bookmarks.js';

/** The page: lessons, files of one's own, and the player. */
@customElement('vidno-app')
export class AppElement extends LitElement {
  static override styles = [tokens, base, appStyle];

  @state() private setup: Setup = {
    language: preferredLanguage(),
    presenting: false,
    layer: 'picture',
    setting: plain,
  };
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
    const { setup, trace, live, ...place } = parseAddress(location.hash);
    this.setup = { ...setup, language: setup.language ?? this.setup.language };
    this.toggleAttribute('embed', setup.setting.embed);
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
      KeyE: () => player.toggleSide('scene'),
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
    const live = await this.session.live.carried();
    const { lesson: trace, place } = this.session;
    return formatAddress({ setup: this.setup, ...place, trace, live });
  }

  private async copyLink(): Promise<void> {
    const { live, lesson } = this.session;
    const isHeld = lesson !== null || (await live.carried()) !== null;
    await live.copyLink(isHeld ? new URL(await this.address(), location.href).href : null);
  }

  private change(part: Partial<Setup>): void {
    this.setup = { ...this.setup, ...part };
    this.writeAddress();
  }

  /** The exact picture is asked for only when it is shown. */
  private get exact(): Exact {
    const { trace, exact } = this.session;
    if (trace === null) return null;
    const { scene } = trace.header;
    return needsExact(this.setup.layer) ? exact.of(scene) : exact.unasked(scene);
  }

  override updated(): void {
    document.documentElement.lang = this.setup.language;
    document.title = this.session.trace ? `${this.name} · vidno` : 'vidno';
  }

  override render(): TemplateResult {
    const { session } = this;
    const { language, presenting, layer, setting } = this.setup;
    const { trace, place, live } = session;
    const page = texts[language].page;
    return html`
      <vidno-page-header
        ?inert=${presenting}
        .language=${language}
        ?open=${trace !== null}
        @keys=${() => this.player.showKeys()}
        @present=${() => this.player.present(true)}
        @choose=${({ detail }: CustomEvent<Language>) => this.change({ language: detail })}
      ></vidno-page-header>
      <nav ?inert=${presenting}>
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
          .ask=${setting.ask ?? ''}
          ?presenting=${presenting}
          ?linked=${session.isLinked}
          .layer=${layer}
          .exact=${this.exact}
          .maps=${session.maps}
          .editing=${live.editing}
          .link=${live.link}
          @vidno-step=${({ detail: step }: CustomEvent<number>) => session.move({ step })}
          @vidno-pixel=${({ detail: pixel }: CustomEvent<Pixel | null>) => session.move({ pixel })}
          @vidno-layer=${({ detail }: CustomEvent<Layer>) => this.change({ layer: detail })}
          @vidno-bookmarks=${({ detail: bookmarks }: CustomEvent<Bookmarks>) => session.move({ bookmarks })}
          @vidno-act=${({ detail }: CustomEvent<Act>) => live.act(detail)}
          @vidno-ask=${({ detail: ask }: CustomEvent<Way>) => this.change({ setting: { ...setting, ask } })}
          @vidno-present=${({ detail }: CustomEvent<boolean>) => this.change({ presenting: detail })}
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
    return found?.title[this.setup.language] ?? this.session.name;
  }

  private heading(): TemplateResult {
    const { page } = texts[this.setup.language];
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
        .language=${this.setup.language}
      ></vidno-notice>
    </div>`;
  }
}
