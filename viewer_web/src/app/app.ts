import { LitElement, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, query, state } from 'lit/decorators.js';
import { keyMap } from '../base/key-map.js';
import { memory } from '../base/memory.js';
import type { StatePart } from '../algorithm/state-part.js';
import type { PageView } from '../base/page-view.js';
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
import '../elements/divider.js';
import '../elements/file-drop.js';
import '../elements/languages.js';
import { Keyboard } from '../elements/keyboard.js';
import type { Actions } from '../elements/keyboard.js';
import { base, tokens } from '../elements/theme.js';
import { texts } from '../i18n/index.js';
import { preferredLanguage } from '../language/language.js';
import type { Language } from '../language/language.js';
import { nameIn } from '../language/scene-name.js';
import { embeddedLessons, idOf } from '../lessons/lessons.js';
import type { LessonTrace } from '../lessons/lessons.js';
import { embeddedAddress } from '../lessons/page-file.js';
import { sceneTitle } from '../lessons/run-name.js';
import '../player/player.js';
import type { PlayerElement } from '../player/player.js';
import { namesNothing, parseAddress } from '../reader/address.js';
import type { Setup } from '../reader/address.js';
import '../solid/solid-element.js';
import { appStyle } from './app.style.js';
import { contents, reader } from './beside.js';
import type { Told } from './beside.js';
import { Breaking } from './breaking.js';
import { heading, invitation, notices } from './heading.js';
import { Navigation } from './navigation.js';
import type { PlaceInFile } from './navigation.js';
import './page-header.js';
import type { Asked } from './page-header.js';
import { Reading } from './reading.js';
import { learningSystemOf } from './scorm.js';
import { Session } from './session.js';
import { share } from './sharing.js';
import './tour.js';
import { atlas, failing } from './failing.js';
import { alone, besides, ownSurface } from './stage.js';
import type { Shown } from './stage.js';

/** A constant, because a new list would make the player render a second time. */
const noParts: readonly StatePart[] = [];
/** The address that begins the tour. */
const tourAddress = '#tour';

/** The page: lessons, the reader's own files, and the player. */
@customElement('vidno-app')
export class AppElement extends LitElement implements Shown, Told {
  static override styles = [tokens, base, appStyle];

  @state() setup: Setup = {
    language: preferredLanguage(),
    view: null,
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
  isFirst = false;
  /** Whether the tour is offered, which happens once, and whether it is running. */
  @state() private isOffered = false;
  @state() private isToured = false;
  /** Whether the page is looking for what the address names. */
  @state() private isOpening = false;
  readonly lessons = embeddedLessons(document);
  readonly keeper = learningSystemOf(window);
  readonly ways: Navigation = new Navigation(this);
  readonly breaking: Breaking = new Breaking(this);
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
    window.addEventListener('pointerdown', this.onElsewhere);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    window.removeEventListener('keydown', this.onKey);
    window.removeEventListener('pointerdown', this.onElsewhere);
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
    this.breaking.openAt(address.witness ?? null);
    this.isOpening = true;
    const isTour = location.hash === tourAddress;
    this.isFirst = namesNothing(address);
    if (this.isFirst && !setup.setting.embed && memory.get('tour') === null) {
      memory.set('tour', 'offered');
      this.isOffered = true;
    }
    void this.reading.follow({ ...address, rival: beside }, this.ways.isUnsaved).finally(() => {
      this.isOpening = false;
      if (isTour) this.showAround();
    });
  }

  /** The lessons cover the page and close when the reader turns to anything else. */
  private readonly onElsewhere = (event: Event): void => {
    const isThere = event
      .composedPath()
      .some((each) => each instanceof Element && each.matches('nav, vidno-page-header'));
    if (!isThere) this.isAtContents = false;
  };

  /** Passes keys that were pressed outside the player on to it. */
  private readonly onKey = (event: KeyboardEvent): void => {
    if (
      this.choice.open ||
      this.discard.open ||
      this.gallery.open ||
      this.session.live.handleKey(event)
    )
      return;
    if (event.key === 'Escape' && this.isAtContents) {
      this.isAtContents = false;
      event.preventDefault();
      return;
    }
    this.keyboard.handle(event);
    if (!event.composedPath().includes(this.stage)) this.stage.handleKey(event);
  };

  /** The element that shows the run, alone or beside another one. */
  private get stage(): PlayerElement | ComparisonElement {
    return this.comparison ?? this.player;
  }

  /** Whether the reader must predict the next step, and so cannot look at it elsewhere. */
  private get isAsked(): boolean {
    return this.setup.setting.ask === 'forced';
  }

  /** Whether the lesson has a text, even if it is hidden. */
  private get hasText(): boolean {
    return this.reading.lesson?.story !== undefined && !this.setup.setting.embed;
  }

  /** Whether the text is shown beside the run. */
  get isReading(): boolean {
    return this.hasText && this.setup.reader && !this.session.isCompared;
  }

  /** The layout of the page: around a text, unless there is none or the reader chose otherwise. */
  get view(): PageView {
    return this.setup.view ?? (this.hasText ? 'lesson' : 'workbench');
  }

  get parts(): readonly StatePart[] {
    return this.reading.story?.shows ?? noParts;
  }

  turned(): void {
    this.requestUpdate();
  }

  offer(): TemplateResult | typeof nothing {
    if (!this.isOffered) return nothing;
    const { tour } = texts[this.setup.language];
    const onClick = (event: Event): void => {
      event.preventDefault();
      this.showAround();
    };
    return html`<p class="offer">
      ${tour.about} <a href=${tourAddress} @click=${onClick}>${tour.offer}</a>
    </p>`;
  }

  private showAround(): void {
    this.isOffered = false;
    this.isAtContents = false;
    this.change({ view: 'lesson', reader: true });
    this.isToured = true;
  }

  private tour(): TemplateResult {
    const inPlayer = (part: string): Element | null | undefined =>
      this.player.shadowRoot?.querySelector(part);
    const parts = (): readonly (Element | null | undefined)[] => [
      inPlayer('.picture'),
      inPlayer('.dock'),
      inPlayer('.listing'),
      this.renderRoot.querySelector('vidno-reader'),
    ];
    return html`<vidno-tour
      .language=${this.setup.language}
      .parts=${parts}
      @end=${() => {
        this.isToured = false;
        this.stage.focusPlay();
      }}
    ></vidno-tour>`;
  }

  turnToContents(isOpen: boolean): void {
    this.isAtContents = isOpen && !this.isAtContents;
  }

  private openFile(file: File): void {
    this.ways.leave();
    this.turnToContents(false);
    this.reading.close();
    void this.session.openFile(file);
  }

  reopen(file: File, place: PlaceInFile): void {
    this.reading.close();
    void this.session.openFile(file, { ...place, bookmarks: [] });
  }

  private turnText(): void {
    if (!this.hasText || this.session.isCompared) return;
    this.change({ view: this.view, reader: !this.setup.reader });
  }

  private turnView(): void {
    if (!this.session.isCompared) {
      this.change({ view: this.view === 'workbench' ? 'lesson' : 'workbench' });
    }
  }

  /** Opens or closes the editor. With two runs it shows or hides the handles in the first picture. */
  private edit(on = !this.isEdited): void {
    const { player, comparison } = this;
    if (comparison !== null) comparison.isEdited = on;
    else if (on !== this.isEdited) player.turnEditor();
  }

  private get isEdited(): boolean {
    return this.comparison?.isEdited ?? this.player.isEdited;
  }

  private ask(what: Asked): void {
    switch (what) {
      case 'skip':
        this.stage.focusPlay();
        return;
      case 'contents':
        this.turnToContents(true);
        return;
      case 'keys':
        this.stage.showKeys();
        return;
      case 'text':
        this.turnText();
        return;
      case 'workbench':
        this.turnView();
        return;
      case 'edit':
        this.edit();
        this.requestUpdate();
        return;
      case 'compare':
        this.compare();
        return;
      case 'present':
        this.stage.present(true);
    }
  }

  /** Shows another run beside this one, or closes it. */
  private compare(): void {
    const { rival, trace } = this.session;
    if (rival.chosen !== null) this.breaking.leave();
    else if (this.isAsked) this.player.refuse('noComparison');
    else if (trace !== null) this.choice.show();
  }

  /** The actions of keys: to change views, to act in them, and to draw a polygon. */
  private actions(): Actions {
    const { live } = this.session;
    const always = {
      KeyD: () => this.compare(),
      KeyR: () => this.turnText(),
      KeyW: () => this.turnView(),
    };
    if (live.editing === null) return always;
    return {
      ...always,
      KeyE: () => this.edit(),
      KeyN: () => {
        if (live.editing?.sketch.curves !== null) return;
        this.edit(true);
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
    const { documentElement: root } = document;
    // Setting the same value again would make the browser restyle the whole page.
    if (root.lang !== this.setup.language) root.lang = this.setup.language;
    const name = this.session.trace ? `${this.name} · vidno` : 'vidno';
    if (document.title !== name) document.title = name;
  }

  override render(): TemplateResult {
    const { session } = this;
    const { language, presenting } = this.setup;
    const { trace, live, rival, isCompared } = session;
    this.toggleAttribute('comparing', isCompared);
    this.toggleAttribute('reading', this.isReading);
    this.setAttribute('view', this.view);
    const isEmpty = trace === null && !session.isOpening;
    const isAtContents = this.isAtContents || isEmpty;
    this.toggleAttribute('contents', isAtContents);
    this.toggleAttribute('empty', isEmpty);
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
        view=${this.view}
        .editing=${live.editing === null ? null : this.isEdited}
        ?contents=${isAtContents}
        .keys=${this.setup.setting.keys}
        @ask=${({ detail }: CustomEvent<Asked>) => this.ask(detail)}
        >${heading(session, this.name, language)}</vidno-page-header
      >
      <main>
        <h2 class="on-paper">${trace === null ? '' : this.name}</h2>
        ${notices(session, language)} ${failing(this)} ${alone(this)}
        ${isCompared ? besides(this) : nothing}
        ${this.isOpening ? nothing : invitation(session, language)}
      </main>
      ${this.hasText ? reader(this) : nothing}
      <vidno-languages
        ?inert=${presenting}
        .chosen=${language}
        @choose=${({ detail }: CustomEvent<Language>) => this.change({ language: detail })}
      ></vidno-languages>
      <nav ?inert=${presenting}>
        ${contents(this)}
        <vidno-file-drop
          .texts=${page}
          @file=${({ detail }: CustomEvent<File>) => this.ways.replace(() => this.openFile(detail))}
        ></vidno-file-drop>
        ${atlas(session, language, () => void this.gallery.show())}
        ${ownSurface(session, language, (name) => void this.ways.replace(() => this.openSurface(name)))}
        ${this.isReading ? html`<button @click=${() => this.showAround()}>${texts[language].tour.again}</button>` : nothing}
      </nav>
      <vidno-rival-choice
        .language=${language}
        .lessons=${this.lessons}
        .options=${live.editing?.options ?? null}
        .earlier=${session.earlier}
        @with=${({ detail }: CustomEvent<With>) => {
          this.ways.leave();
          rival.choose(detail);
        }}
      ></vidno-rival-choice>
      ${this.isToured ? this.tour() : nothing}
      <vidno-gallery
        .language=${language}
        .library=${session.library}
        @choose=${({ detail }: CustomEvent<Entry>) => this.ways.replace(() => this.openEntry(detail))}
      ></vidno-gallery>
      <vidno-discard
        .language=${language}
        .name=${nameIn(language, live.editing?.sketch.name ?? '')}
      ></vidno-discard>
    `;
  }

  private openEntry({ name }: Entry): void {
    this.ways.leave();
    this.reading.close();
    this.session.rival.choose(null);
    void this.session.openEntry(name);
  }

  private openSurface(name: string): void {
    this.ways.leave();
    this.turnToContents(false);
    this.reading.close();
    this.session.openSurface(name);
    this.player.isEdited = true;
  }

  /** A run of a lesson is named after its trace, a failure after its effect. */
  private get name(): string {
    const { session, setup } = this;
    if (session.isFailing && session.failure !== null) return session.failure.title[setup.language];
    const isOpen = (trace: LessonTrace): boolean => idOf(trace) === session.lesson;
    const lesson = this.lessons.find(({ traces }) => traces.some(isOpen));
    const run = lesson?.traces.find(isOpen)?.title ?? lesson?.title;
    const { language } = setup;
    return run?.[language] ?? sceneTitle(language, session.name);
  }
}
