import { LitElement, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, query, state } from 'lit/decorators.js';
import { keyMap } from '../base/key-map.js';
import { plain } from '../base/setting.js';
import '../atlas/failure-note.js';
import type { Entry } from '../atlas/entries.js';
import '../atlas/gallery.js';
import type { GalleryElement } from '../atlas/gallery.js';
import '../compare/comparison-element.js';
import type { ComparisonElement } from '../compare/comparison-element.js';
import { withOf } from '../compare/rival.js';
import type { With } from '../compare/rival.js';
import '../compare/rival-choice.js';
import type { RivalChoiceElement } from '../compare/rival-choice.js';
import '../editor/discard.js';
import type { DiscardElement } from '../editor/discard.js';
import '../elements/file-drop.js';
import { Keyboard } from '../elements/keyboard.js';
import type { Actions } from '../elements/keyboard.js';
import { base, tokens } from '../elements/theme.js';
import { texts } from '../i18n/index.js';
import { preferredLanguage } from '../language/language.js';
import type { Language } from '../language/language.js';
import { embeddedLessons, idOf } from '../lessons/lessons.js';
import { embeddedAddress } from '../lessons/page-file.js';
import '../player/player.js';
import type { PlayerElement } from '../player/player.js';
import { parseAddress } from '../reader/address.js';
import type { Setup } from '../reader/address.js';
import '../solid/solid-element.js';
import { appStyle } from './app.style.js';
import { contents, reader } from './beside.js';
import type { Told } from './beside.js';
import { heading, invitation } from './heading.js';
import { Navigation } from './navigation.js';
import './page-header.js';
import { Reading } from './reading.js';
import { Session } from './session.js';
import { share } from './sharing.js';
import { atlas, failing } from './failing.js';
import { alone, besides, ownSurface } from './stage.js';
import type { Shown } from './stage.js';

/** The page: lessons, files of one's own, and the player. */
@customElement('vidno-app')
export class AppElement extends LitElement implements Shown, Told {
  static override styles = [tokens, base, appStyle];

  @state() setup: Setup = {
    language: preferredLanguage(),
    presenting: false,
    layer: 'picture',
    setting: plain,
    reader: true,
    follows: false,
  };
  @query('vidno-player') private player!: PlayerElement;
  @query('vidno-comparison') private comparison!: ComparisonElement | null;
  @query('vidno-rival-choice') private choice!: RivalChoiceElement;
  @query('vidno-gallery') private gallery!: GalleryElement;
  @query('vidno-discard') readonly discard!: DiscardElement;

  @state() private isAtContents = false;
  /** What the address names is being looked for. */
  @state() private isOpening = false;
  readonly lessons = embeddedLessons(document);
  readonly ways: Navigation = new Navigation(this);
  readonly session = new Session(this, () => {
    this.requestUpdate();
    this.ways.write();
  });
  readonly reading = new Reading(
    this.lessons,
    this.session,
    () => {
      this.requestUpdate();
      this.ways.write();
    },
    () => this.ways.leave(),
  );
  private readonly keyboard = new Keyboard(this, () => this.actions(), true);

  override connectedCallback(): void {
    super.connectedCallback();
    this.followAddress();
    window.addEventListener('keydown', this.onKey);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    window.removeEventListener('keydown', this.onKey);
  }

  followAddress(): void {
    const address = parseAddress(location.hash || embeddedAddress(document));
    const { setup, rival } = address;
    this.setup = { ...setup, language: setup.language ?? this.setup.language };
    this.toggleAttribute('embed', setup.setting.embed);
    keyMap.word = setup.setting.keys;
    const { session } = this;
    const beside = this.isAsked ? null : rival;
    if (beside !== session.rival.word) session.rival.choose(withOf(beside ?? '', document));
    this.isOpening = true;
    void this.reading.follow(address).finally(() => (this.isOpening = false));
  }

  /** Keys that were pressed outside the player are passed on to it. */
  private readonly onKey = (event: KeyboardEvent): void => {
    if (
      this.choice.open ||
      this.discard.open ||
      this.gallery.open ||
      this.session.live.handleKey(event)
    )
      return;
    this.keyboard.handle(event);
    if (!event.composedPath().includes(this.stage)) this.stage.handleKey(event);
  };

  /** What shows the run: alone, or beside another one. */
  private get stage(): PlayerElement | ComparisonElement {
    return this.comparison ?? this.player;
  }

  /** The reader has to answer what comes next, and cannot look at it beside. */
  private get isAsked(): boolean {
    return this.setup.setting.ask === 'forced';
  }

  /** Whether there is the text of a lesson, though it may be out of sight. */
  private get hasText(): boolean {
    return this.reading.lesson?.story !== undefined && !this.setup.setting.embed;
  }

  /** Whether it is beside the run. */
  get isReading(): boolean {
    return this.hasText && this.setup.reader && !this.session.isCompared;
  }

  turnToContents(isOpen: boolean): void {
    this.isAtContents = isOpen && !this.isAtContents;
  }

  private openFile(file: File): void {
    this.ways.leave();
    this.reading.close();
    void this.session.openFile(file);
  }

  private turnText(): void {
    if (this.hasText && !this.session.isCompared) this.change({ reader: !this.setup.reader });
  }

  /** To another run beside this one, and back. */
  private compare(): void {
    const { rival, trace } = this.session;
    if (rival.chosen !== null) rival.choose(null);
    else if (this.isAsked) this.player.refuse('noComparison');
    else if (trace !== null) this.choice.show();
  }

  /** To the scene and back to the state; to the drawing of a polygon; to the comparison. */
  private actions(): Actions {
    const { player, comparison } = this;
    const { live } = this.session;
    const compare = { KeyD: () => this.compare(), KeyR: () => this.turnText() };
    if (live.editing === null) return compare;
    const edit = (on: boolean): void => {
      if (comparison !== null) comparison.isEdited = on;
      else if (on !== (player.side === 'scene')) player.toggleSide('scene');
    };
    return {
      ...compare,
      KeyE: () => edit(comparison === null ? player.side !== 'scene' : !comparison.isEdited),
      KeyN: () => {
        if (live.editing?.sketch.curves !== null) return;
        edit(true);
        live.act({ do: 'draw' });
      },
    };
  }

  copyLink(): Promise<void> {
    return share(this);
  }

  change(part: Partial<Setup>): void {
    this.setup = { ...this.setup, ...part };
    this.ways.write();
  }

  override updated(): void {
    document.documentElement.lang = this.setup.language;
    document.title = this.session.trace ? `${this.name} · vidno` : 'vidno';
  }

  override render(): TemplateResult {
    const { session } = this;
    const { language, presenting } = this.setup;
    const { trace, live, rival, isCompared } = session;
    this.toggleAttribute('comparing', isCompared);
    this.toggleAttribute('reading', this.isReading);
    this.toggleAttribute('contents', this.isReading && this.isAtContents);
    const page = texts[language].page;
    return html`
      <vidno-page-header
        ?inert=${presenting}
        .language=${language}
        ?open=${trace !== null}
        ?comparing=${rival.chosen !== null}
        ?alone=${this.isAsked}
        ?told=${this.hasText && !isCompared}
        ?reading=${this.isReading}
        .keys=${this.setup.setting.keys}
        @skip=${() => this.stage.focusPlay()}
        @text=${() => this.turnText()}
        @keys=${() => this.stage.showKeys()}
        @compare=${() => this.compare()}
        @present=${() => this.stage.present(true)}
        @choose=${({ detail }: CustomEvent<Language>) => this.change({ language: detail })}
      ></vidno-page-header>
      <main>
        ${heading(session, this.name, language)} ${failing(this)} ${alone(this)}
        ${isCompared ? besides(this) : nothing}
        ${this.isOpening ? nothing : invitation(session, language)}
      </main>
      <nav ?inert=${presenting}>
        ${contents(this)}
        <vidno-file-drop
          .texts=${page}
          @file=${({ detail }: CustomEvent<File>) => this.ways.replace(() => this.openFile(detail))}
        ></vidno-file-drop>
        ${atlas(session, language, () => void this.gallery.show())}
        ${ownSurface(session, language, (name) => void this.ways.replace(() => this.openSurface(name)))}
      </nav>
      ${this.hasText ? reader(this) : nothing}
      <vidno-rival-choice
        .language=${language}
        .lessons=${this.lessons}
        .options=${live.editing?.options ?? null}
        .earlier=${session.earlier}
        @with=${({ detail }: CustomEvent<With>) => rival.choose(detail)}
      ></vidno-rival-choice>
      <vidno-gallery
        .language=${language}
        .library=${session.library}
        @choose=${({ detail }: CustomEvent<Entry>) => this.ways.replace(() => this.openFailure(detail))}
      ></vidno-gallery>
      <vidno-discard .language=${language} .name=${live.editing?.sketch.name ?? ''}></vidno-discard>
    `;
  }

  private openFailure({ text, name }: Entry): void {
    this.ways.leave();
    this.reading.close();
    this.session.rival.choose(null);
    void this.session.openFailure(text, name);
  }

  private openSurface(name: string): void {
    this.ways.leave();
    this.reading.close();
    this.session.openSurface(name);
    this.player.side = 'scene';
  }

  private get name(): string {
    const found = this.lessons.find(({ traces }) =>
      traces.some((each) => idOf(each) === this.session.lesson),
    );
    return found?.title[this.setup.language] ?? this.session.name;
  }
}
