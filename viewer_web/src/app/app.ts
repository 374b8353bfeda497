import { LitElement, css, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, query, state } from 'lit/decorators.js';
import { keyMap } from '../base/key-map.js';
import type { StatePart } from '../algorithm/shows.js';
import type { PageView } from '../base/setting.js';
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
import { base, leastPanel, lowScreen, tokens, zoomButtons } from '../elements/theme.js';
import { texts } from '../i18n/index.js';
import { languages, preferredLanguage } from '../language/language.js';
import type { Language } from '../language/language.js';
import { nameIn } from '../language/scene-name.js';
import { embeddedLessons, idOf } from '../lessons/lessons.js';
import type { LessonTrace } from '../lessons/lessons.js';
import { embeddedAddress } from '../lessons/page-file.js';
import { sceneTitle } from '../lessons/run-name.js';
import type { Front, PlayerElement } from '../player/player.js';
import { listedIn } from '../reader/story.js';
import { namesNothing, parseAddress } from '../reader/address.js';
import type { Setup } from '../reader/address.js';
import '../solid/solid-element.js';
import { contents, reader } from './beside.js';
import type { PageBeside } from './beside.js';
import { Breaking } from './breaking.js';
import { heading, invitation, notices } from './heading.js';
import { Messages } from './messages.js';
import { Navigation } from './navigation.js';
import type { PlaceInFile } from './navigation.js';
import './page-header.js';
import type { Asked, Menu } from './page-header.js';
import './player.js';
import { Reading } from './reading.js';
import { learningSystemOf } from './scorm.js';
import { Session } from './session.js';
import { share } from './sharing.js';
import './tour.js';
import { failing } from './failing.js';
import { own } from './own.js';
import { alone, besides } from './stage.js';
import type { Shown } from './stage.js';

/** The header; below it the text, if there is one, and the run; over these, on demand, the lessons. */
const appStyle = css`
  :host {
    /* The links to other languages: they come last for the keyboard, but have their place in the header. */
    --languages: ${languages.length - 1};
    --pad: 0.75rem;
    --gap: 0.625rem;
    position: relative;
    box-sizing: border-box;
    display: grid;
    height: 100dvh;
    padding: 0 var(--pad) var(--pad);
    grid-template: 'header' 3rem 'main' minmax(0, 1fr) / minmax(0, 1fr);
    background: var(--paper);
  }
  :host([reading]) {
    grid-template:
      'header header header' 3rem
      'reader fold main' minmax(0, 1fr) / minmax(0, var(--text, var(--text-share, 30fr))) var(--gap)
      minmax(${leastPanel}, var(--text-rest, 70fr));
  }
  vidno-page-header {
    grid-area: header;
    padding-right: calc(5rem * var(--languages));
  }
  vidno-languages {
    grid-area: header;
    justify-self: end;
    height: 3rem;
  }
  vidno-reader {
    grid-area: reader;
  }
  .fold {
    grid-area: fold;
  }
  main {
    grid-area: main;
    display: flex;
    flex-direction: column;
    min-height: 0;
    min-width: 0;
    overflow: auto;
  }
  vidno-player,
  vidno-comparison {
    flex: 1 0 auto;
  }
  /* With a given size the browser need not compute the content's height, for which it would style and lay out everything
     once more. */
  @media (min-width: 900px) {
    vidno-player {
      flex: 1 0 0;
    }
  }
  /* The name and below it the settings of the run. */
  .title {
    display: flex;
    flex-direction: column;
    align-items: flex-start;
    justify-content: center;
    min-width: 0;
  }
  .title > * {
    max-width: 100%;
  }
  .title h2 {
    overflow: hidden;
    color: var(--ink);
    font-size: 1rem;
    line-height: 1.25rem;
    letter-spacing: 0;
    text-overflow: ellipsis;
    white-space: nowrap;
  }
  .greeting {
    margin: 1rem 1.25rem -0.5rem;
    color: var(--soft);
    font-size: 0.875rem;
  }
  .greeting a {
    color: var(--accent);
  }
  .on-paper {
    display: none;
  }
  .nothing {
    margin: auto;
    color: var(--soft);
  }
  /* Shown only if reading takes long: the run opens while the reader scrolls, and nothing should flicker. */
  :host([reading]) vidno-notice.reading {
    position: absolute;
    right: 0.9rem;
    z-index: 2;
    animation: late 0.3s step-end backwards;
  }
  @keyframes late {
    from {
      opacity: 0;
    }
  }
  nav {
    position: absolute;
    z-index: 5;
    top: 2.9rem;
    left: var(--pad);
    display: none;
    flex-direction: column;
    gap: 0.6rem;
    width: min(26rem, 100% - 2 * var(--pad));
    max-height: calc(100dvh - 3.7rem);
    padding: 0.6rem;
    overflow: auto;
    border: 1px solid var(--line);
    border-radius: var(--radius);
    background: var(--panel);
    box-shadow: 0 8px 32px rgb(10 12 18 / 30%);
  }
  :host([menu]) nav {
    display: flex;
  }
  /* Below the button that opens it. */
  :host([menu='own']) nav {
    right: var(--pad);
    left: auto;
  }
  nav > * {
    flex: none;
  }
  /* Without a run the contents hide nothing. */
  :host([empty]) main {
    margin-left: calc(min(26rem, 100% - 2 * var(--pad)) + var(--pad));
  }
  vidno-lesson-list {
    border: 0;
    padding: 0;
  }
  :host([menu='lessons']:not([empty])) .own,
  :host([menu='own']:not([empty])) nav > :not(.own) {
    display: none;
  }
  .own {
    display: grid;
    gap: 0.6rem;
  }
  :host([comparing]) nav {
    display: none;
  }
  @media (max-width: 1199px) {
    :host {
      --text-share: 38fr;
    }
  }
  /* The page scrolls: the run comes first, and the box of the text fills the rest of the screen. */
  @media (max-width: 899px) {
    :host {
      height: auto;
      min-height: 100dvh;
      grid-template: 'header' auto 'main' 1fr / minmax(0, 1fr);
    }
    vidno-languages {
      height: 2.75rem;
    }
    vidno-page-header {
      padding-right: 0;
    }
    main {
      overflow: visible;
    }
    :host([empty]) main {
      margin: 0 0.6rem;
    }
    :host([empty]) nav {
      position: static;
      width: auto;
      max-height: none;
      margin: 0 0.6rem 0.6rem;
    }
    .title {
      flex: 1;
    }
    :host([reading]) .fold,
    :host([reading]) vidno-page-header:not([more]) .title {
      display: none;
    }
    :host([reading]) {
      --pad: 0px;
      --foot: 0px;
      --legend: none;
      --more-controls: none;
      --readout: flex;
      --readout-position: absolute;
      --dock: 6.9rem;
      --room: calc(max(${leastPanel}, min(100vw, 50dvh)) + var(--dock));
      grid-template:
        'header' auto
        'main' auto
        'reader' minmax(min(16.4rem, 100dvh), 1fr) / minmax(0, 1fr);
      gap: 0.4rem 0;
    }
    :host([reading][view='workbench']) {
      --dock: 18.7rem;
    }
    :host([reading][front='run']) vidno-reader {
      display: none;
    }
    :host([reading]) main:has(> vidno-player[asking]) {
      --room: 0px;
    }
    :host([reading]) :is(vidno-page-header, vidno-languages, vidno-notice) {
      padding-inline: 0.6rem;
    }
    :host([reading]) vidno-reader {
      contain: size;
      border-width: 1px 0 0;
      border-radius: 0;
    }
  }
  @media (max-width: 640px) {
    :host {
      --pad: 0px;
    }
    :is(vidno-page-header, vidno-languages, vidno-notice) {
      padding-inline: 0.6rem;
    }
    vidno-comparison {
      --name-inset: 0.6rem;
    }
  }
  /* The panels are beside the picture, and the text is below both. */
  @media (min-width: 704px) and (max-width: 899px) {
    :host([reading]) main:not(:has(> vidno-player[asking])) {
      height: var(--room);
      overflow: auto;
    }
    :host([reading][front='run']) vidno-reader {
      display: flex;
    }
  }
  /* On an upright phone the picture has nearly the full width, and the page scrolls its header away for the text. */
  @media (max-width: 520px) and (orientation: portrait) {
    :host([reading]) {
      --least-room: calc(min(100vw, 26rem) + var(--dock));
      --room: clamp(
        var(--least-room),
        100dvh - 3.25rem,
        max(${leastPanel}, 96vw) + ${zoomButtons} + var(--dock)
      );
    }
  }
  /* A phone on its side: the picture is as high as the screen, and beside it, below the controls, is the text or the panels. */
  @media ${lowScreen} {
    :host(:is([view], [reading])) {
      --pad: 0px;
      --gap: 0.4rem;
      --dock: 11.2rem;
      --room: calc(100dvh - 2.75rem);
      gap: 0;
      height: auto;
      min-height: 100dvh;
      grid-template: 'header' minmax(2.75rem, auto) 'main' auto / minmax(0, 1fr);
    }
    :host(:is([view], [reading])) main {
      height: auto;
      overflow: visible;
    }
    :host([embed][view]) {
      --room: 100dvh;
      grid-template: 'main' auto / minmax(0, 1fr);
    }
    :host([reading]) .fold {
      display: none;
    }
    :host([reading]) vidno-reader {
      display: flex;
      grid-area: main;
      align-self: start;
      justify-self: end;
      width: calc(100% - var(--room) - var(--gap));
      height: calc(var(--room) - var(--dock) - var(--gap));
      margin-top: calc(var(--dock) + var(--gap));
      contain: size;
    }
    :host([reading][front='run']) vidno-reader {
      display: none;
    }
  }
  /* Two pictures and their sentences fit on one screen. */
  @media (min-width: 641px) and (max-width: 1199px) {
    vidno-comparison {
      --panels: clamp(20rem, 100dvh - 28.5rem, 36rem);
    }
  }
  :host([embed]) {
    grid-template: 'main' minmax(0, 1fr) / minmax(0, 1fr);
    height: 100dvh;
    padding: 0;
  }
  :host([embed]) :is(vidno-page-header, vidno-languages, nav) {
    display: none;
  }
  @media print {
    :host {
      display: flex;
      flex-direction: column;
      height: 268mm;
      min-height: 0;
      padding: 0;
      overflow: hidden;
    }
    :is(
      vidno-page-header,
      vidno-languages,
      vidno-divider,
      nav,
      vidno-notice,
      vidno-tour,
      .greeting
    ) {
      display: none;
    }
    main {
      flex: 1;
      overflow: visible;
    }
    .on-paper {
      display: block;
      margin-bottom: 3mm;
      color: var(--ink);
      font-size: 1rem;
      overflow-wrap: anywhere;
    }
    vidno-player,
    vidno-comparison {
      flex: 1;
    }
    :host([reading]) {
      display: block;
      height: auto;
      overflow: visible;
    }
    :host([reading]) :is(main, nav) {
      display: none;
    }
    /* A sheet is as narrow as a small screen. With its size contained the text would be cut between sheets, through its lines. */
    :host([reading]) vidno-reader {
      contain: none;
    }
  }
`;

/** A constant, because a new list would make the player render a second time. */
const noParts: readonly StatePart[] = [];
/** The address that begins the tour. */
const tourAddress = '#tour';

/** The page: lessons, the reader's own files, and the player. */
@customElement('vidno-app')
export class AppElement extends LitElement implements Shown, PageBeside {
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

  @state() private menu: Menu | null = null;
  /** What is in front on a screen that has no room for both the text and the panels. */
  @state() front: Front = 'text';
  isFirst = false;
  /** Whether the tour is running. */
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
  readonly messages = new Messages(this, () => (this.session.trace === null ? null : this.stage));

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
    this.front = 'text';
    void this.reading.follow({ ...address, rival: beside }, this.ways.isUnsaved).finally(() => {
      this.isOpening = false;
      if (isTour) this.showAround();
    });
  }

  /** A menu covers the page and closes when the reader turns to anything else. */
  private readonly onElsewhere = (event: Event): void => {
    const isThere = event
      .composedPath()
      .some((each) => each instanceof Element && each.matches('nav, vidno-page-header'));
    if (!isThere) this.closeMenu();
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
    if (event.key === 'Escape' && this.menu !== null) {
      this.closeMenu();
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

  /** The procedures and lines that the text explains. */
  get listed(): readonly string[] {
    return listedIn(this.reading.story);
  }

  /** Whether no other lesson comes before the text. */
  get isFirstLesson(): boolean {
    return this.reading.story?.prerequisites?.length === 0 && this.listed.length > 0;
  }

  /** A panel that the reader opens is in front. */
  turned(): void {
    if (this.player.side !== 'state' || this.player.isEdited) this.front = 'run';
    this.requestUpdate();
  }

  greeting(): TemplateResult | typeof nothing {
    if (!this.isFirst) return nothing;
    const { tour } = texts[this.setup.language];
    const onClick = (event: Event): void => {
      event.preventDefault();
      this.showAround();
    };
    return html`<p class="greeting">
      ${tour.about} <a href=${tourAddress} @click=${onClick}>${tour.offer}</a>
    </p>`;
  }

  private showAround(): void {
    this.closeMenu();
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

  closeMenu(): void {
    this.menu = null;
  }

  private turnTo(menu: Menu): void {
    this.menu = this.menu === menu ? null : menu;
  }

  private openFiles(files: readonly File[]): void {
    this.ways.leave();
    this.closeMenu();
    void this.session.openFiles(files, this.closeText);
  }

  reopen(file: File, place: PlaceInFile): void {
    void this.session.openFiles([file], this.closeText, { ...place, bookmarks: [] });
  }

  private readonly closeText = (): void => this.reading.close();

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
        this.turnTo('lessons');
        return;
      case 'own':
        this.turnTo('own');
        return;
      case 'atlas':
        void this.gallery.show();
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
    this.setAttribute('front', this.front);
    const isEmpty = trace === null && !session.isOpening;
    const { menu } = this;
    if (menu === null && !isEmpty) this.removeAttribute('menu');
    else this.setAttribute('menu', menu ?? 'lessons');
    this.toggleAttribute('empty', isEmpty);
    return html`
      <vidno-page-header
        ?inert=${presenting}
        .language=${language}
        ?open=${trace !== null}
        ?comparing=${rival.chosen !== null}
        ?alone=${this.isAsked}
        ?has-text=${this.hasText && !isCompared}
        ?reading=${this.isReading}
        view=${this.view}
        .editing=${live.editing === null ? null : this.isEdited}
        .menu=${menu ?? (isEmpty ? 'lessons' : null)}
        ?atlas=${session.canRun && document.getElementById('vidno-atlas') !== null}
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
        ${this.isReading ? html`<button class="again" @click=${() => this.showAround()}>${texts[language].tour.again}</button>` : nothing}
        ${own(session.canRun, language, {
          draw: () => void this.ways.replace(() => this.draw()),
          surface: (name) => void this.ways.replace(() => this.openSurface(name)),
          files: (files) => void this.ways.replace(() => this.openFiles(files)),
        })}
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
    this.session.rival.choose(null);
    void this.session.openEntry(name, undefined, this.closeText);
  }

  private openSurface(name: string): void {
    this.ways.leave();
    this.closeMenu();
    this.session.openSurface(name, this.closeText);
    this.player.isEdited = true;
  }

  /** An empty scene, in which the first polygon is being drawn. */
  private draw(): void {
    this.ways.leave();
    this.closeMenu();
    this.session.openEmpty(() => {
      this.closeText();
      this.player.isEdited = true;
    });
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
