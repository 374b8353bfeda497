import { html, nothing } from 'lit';
import type { PropertyValues, TemplateResult } from 'lit';
import { customElement, property, query, state } from 'lit/decorators.js';
import { sayThing } from '../algorithm/pointed.js';
import { viewOf } from '../algorithm/view.js';
import type { View } from '../algorithm/view.js';
import type { StatePart } from '../algorithm/state-part.js';
import { withKey } from '../base/key-map.js';
import type { PageView } from '../base/page-view.js';
import { isWay, plain } from '../base/setting.js';
import type { Editing } from '../editor/editor.js';
import type { LinkMade } from '../editor/live.js';
import '../editor/scene-panel.js';
import { announcerStyle } from '../elements/announcer.style.js';
import '../elements/divider.js';
import { findingMarks } from '../exactness/finding-marks.js';
import { marginMarks } from '../exactness/margin.js';
import type { Margin } from '../exactness/margin.js';
import { hiddenStyle } from '../elements/hidden.style.js';
import type { Actions } from '../elements/keyboard.js';
import { isOnlyEdited } from '../elements/only-edited.js';
import { withTerms } from '../elements/term.js';
import { base, tokens } from '../elements/theme.js';
import type { Check } from '../exactness/truth.js';
import type { History } from '../history/history.js';
import { PixelHistory } from '../history/pixel-history.js';
import { hasSolid, sideKeys, sideName, whyNoSolid } from '../history/side-name.js';
import type { Side } from '../history/side-name.js';
import { FirstTerms } from '../i18n/glossary.js';
import { texts } from '../i18n/index.js';
import '../listing/listing-element.js';
import type { ListingElement } from '../listing/listing-element.js';
import { needsExact } from '../picture/layers.js';
import type { Exact, Layer } from '../picture/layers.js';
import { isOther } from '../picture/pixel.js';
import type { Mark } from '../picture/mark.js';
import type { Pixel } from '../picture/pixel.js';
import type { Keeper } from '../predict/keeper.js';
import { Predictor } from '../predict/predictor.js';
import type { SignMaps } from '../run/sign-maps.js';
import { bookmarksUpTo } from '../time/bookmarks.js';
import type { Trace } from '../replay/trace.js';
import type { Bookmarks } from '../time/bookmarks.js';
import type { Command } from '../time/command.js';
import type { TravelElement } from '../time/travel.js';
import { embeddedStyle } from './embedded.style.js';
import './picture-panel.js';
import type { PicturePanelElement } from './picture-panel.js';
import { arrangementOf, isShown } from './panels.js';
import { actionsOf } from './player-keys.js';
import { playerStyle } from './player.style.js';
import { Pointing } from './pointing.js';
import { presenterStyle } from './presenter.style.js';
import './side.js';
import type { SideElement } from './side.js';
import { Source } from './source.js';
import { StageElement } from './stage-element.js';
import { verdictOn } from './verdict.js';

/**
 * Replays a trace. Set `src`, or `trace` and `length`. The attributes `step`, `pixel`, `bookmarks` and `lang` may be set,
 * and change with the controls. An event `vidno-step` reports each new step, `vidno-pixel` each chosen pixel, and
 * `vidno-bookmarks` changed bookmarks; `linked` states that the page's address contains these.
 */
@customElement('vidno-player')
export class PlayerElement extends StageElement {
  static override styles = [
    tokens,
    base,
    hiddenStyle,
    playerStyle,
    embeddedStyle,
    presenterStyle,
    announcerStyle,
  ];

  /** The address of a trace, or `#id` of a block of JSON Lines in the page. Without it, `trace` and `length` are set. */
  @property() src = '';
  /** The visible controls, see `Controls`; any other value means `full`. */
  @property({ reflect: true }) controls: string = plain.controls;
  @property({ attribute: false, hasChanged: isOther }) pixel: Pixel | null = null;
  /** The layer that the pixels show, if the trace has it. An event `vidno-layer` asks for another one. */
  @property({ attribute: false }) layer: Layer = 'picture';
  /** The source of sign maps; null without the library. */
  @property({ attribute: false }) maps: SignMaps | null = null;
  /** The region to which the chosen vertex can move without changing a sign of the step, if it is known. */
  @property({ attribute: false }) margin: Margin | null = null;
  /** The exact picture of the scene. */
  @property({ attribute: false }) exact: Exact = null;
  @property({ type: Boolean }) linked = false;
  /** The scene, if it can be edited. Events `vidno-act`, `vidno-save` and `vidno-link` carry requests for it. */
  @property({ attribute: false }) editing: Editing | null = null;
  @property({ attribute: false }) link: LinkMade | null = null;
  /** Whether lines of the listing can be broken; an event `vidno-break` asks for that. */
  @property({ type: Boolean }) breakable = false;
  /** How questions are asked, see `Way`. An event `vidno-ask` reports that the reader has changed it. */
  @property() ask = '';
  /** What keeps the score of the answers when the page is closed. */
  @property({ attribute: false }) keeper: Keeper | null = null;
  /** Whether a text is beside the player, which leaves room for two columns. */
  @property({ type: Boolean, reflect: true }) beside = false;
  /** The arrangement, and the parts of the state that a lesson asks for. */
  @property({ reflect: true }) layout: PageView = 'workbench';
  @property({ attribute: false }) parts: readonly StatePart[] = [];
  /** The query of the outline's search, and the steps found. */
  @state() private sought = '';
  @state() private hits: readonly number[] = [];
  /** The panel beside the listing. */
  @property({ attribute: false }) side: Side = 'state';
  /** Whether the scene is being edited, beside listing and state. */
  @property({ attribute: false }) isEdited = false;
  @query('vidno-listing') readonly listing!: ListingElement;
  @query('vidno-picture-panel') readonly picture!: PicturePanelElement;
  @query('vidno-travel') readonly travel!: TravelElement;
  @query('vidno-side') private panel!: SideElement;
  private view: View | null = null;
  private readonly source = new Source(this);
  private readonly pointing = new Pointing(this);
  readonly predictor = new Predictor(this);
  private readonly chosen = new PixelHistory(this);

  /** The marks of the region to which the chosen vertex can move without changing a sign of the step. */
  private marginMarks(): readonly Mark[] | undefined {
    const { trace, margin, isEdited } = this;
    if (trace === null || margin === null || !isEdited) return undefined;
    const { exact, numbers } = texts[this.language];
    const words = { say: exact.margin, point: numbers.point };
    return marginMarks(margin, trace.header.scene.area, words);
  }

  override willUpdate(changed: PropertyValues<this>): void {
    if (isOnlyEdited(changed)) return;
    this.predictor.follow();
    super.willUpdate(changed);
    if (changed.has('trace')) this.hits = [];
    if (this.trace !== null) this.bookmarks = bookmarksUpTo(this.bookmarks, this.length);
    this.chosen.follow(changed);
    if (changed.has('ask') && isWay(this.ask)) this.side = 'predict';
    this.toggleAttribute('asking', this.side === 'predict');
    const { language, trace } = this;
    const pixel = this.chosen.history?.pixel ?? null;
    const { things: asked } = this.predictor;
    const step = trace === null ? 0 : this.step;
    const findings = trace && this.side === 'exact' ? this.checkOf(trace).findings : undefined;
    const found = findings ? findingMarks(findings, step) : this.marginMarks();
    const choice = { language, pixel, pointed: this.pointing.at, asked, ...(found && { found }) };
    const view = trace && viewOf(trace, step, choice);
    this.view = view && { ...view, targets: this.predictor.targetsIn(view) };
  }

  override updated(changed: PropertyValues<this>): void {
    super.updated(changed);
    if (changed.has('side') || changed.has('isEdited')) {
      this.dispatchEvent(new CustomEvent('vidno-side'));
    }
  }

  protected override actions(event: KeyboardEvent): Actions {
    return actionsOf(this, event);
  }

  protected override get limit(): number {
    return Math.min(this.last, this.predictor.limit);
  }

  /** Whether all controls and all panels are available. */
  get isFull(): boolean {
    return this.controls !== 'small' && this.controls !== 'none';
  }

  /** Opens a panel. If it is open, opens the state instead. */
  toggleSide(side: Side): void {
    const { view } = this;
    if (!this.isFull || view === null) return;
    const { news } = view.texts;
    const refused = side === 'solid' ? whyNoSolid(view) : null;
    if (refused !== null) this.announcer.refuse(news[refused]);
    else {
      this.side = this.side === side ? 'state' : side;
      this.announcer.say(news.panel(sideName(this.side, view)));
      if (this.side === side) void this.updateComplete.then(() => this.panel.bringIntoSight());
    }
  }

  /** Opens or closes the editor. */
  turnEditor(): void {
    const { view, language } = this;
    if (!this.isFull || view === null || this.editing === null) return;
    this.isEdited = !this.isEdited;
    const { scene } = texts[language].scene;
    this.announcer.say(view.texts.news.panel(this.isEdited ? scene : sideName(this.side, view)));
  }

  /** Closes the questions, unless the run waits for an answer. */
  escape(): void {
    if (this.side !== 'predict') return;
    if (this.predictor.leave()) this.toggleSide('predict');
    else this.refuse('answerFirst');
  }

  refuse(why: 'answerFirst' | 'noComparison'): void {
    this.announcer.refuse(this.view?.texts.news[why] ?? '');
  }

  async openBookmarks(way: 'mark' | 'enter'): Promise<void> {
    if (!this.isFull) return;
    this.side = 'bookmarks';
    await this.updateComplete;
    await this.panel.bookmark(way);
  }

  async enterOutline(): Promise<void> {
    if (!this.isFull) return;
    if (this.side !== 'outline') this.toggleSide('outline');
    await this.updateComplete;
    await this.panel.enterOutline();
  }

  private keepBookmarks(bookmarks: Bookmarks): void {
    this.bookmarks = bookmarks;
    this.dispatchEvent(new CustomEvent('vidno-bookmarks', { detail: bookmarks }));
  }

  override render(): TemplateResult | typeof nothing {
    const { view, trace } = this;
    if (view === null || trace === null) return this.source.remark(this.language);
    const { texts } = view;
    // An open question hides everything that shows the future and would answer it.
    const { isOpen, isForced } = this.predictor;
    const veiled = isOpen || isForced;
    const history = isOpen ? null : this.chosen.history;
    const check = this.checkOf(trace);
    const layer = isOpen && needsExact(this.layer) ? 'picture' : this.layer;
    return html`
      ${this.source.remark(this.language)}
      <div
        class="stage"
        @pointerover=${this.pointing.onOver}
        @pointerleave=${this.pointing.onLeave}
      >
        <div class="dock">
          ${this.announcer.render()}
          <div class="said">
            <p
              class="sentence"
              aria-live=${this.clock.playing ? 'off' : 'polite'}
              aria-atomic="true"
            >
              <span class="at">${view.event?.at ?? '·'}</span
              ><span>${withTerms(view.sentence, termsIn(view))} ${this.verdict(trace, view)}</span>
            </p>
            ${this.presenter.corner(view)}
          </div>
          ${this.playControls(view, check, history, {
            plain: !this.isFull,
            brief: arrangementOf(this.layout).isBrief,
            veiled,
            hits: this.hits,
          })}
          ${this.asides(view)}
        </div>
        <section class="picture" aria-label=${texts.picture}>
          <vidno-picture-panel
            .view=${view}
            .editing=${this.edited}
            .layer=${layer}
            .exact=${this.exact}
            @pixel=${({ detail }: CustomEvent<Pixel>) => this.chosen.choose(detail)}
          ></vidno-picture-panel>
        </section>
        <vidno-divider
          class="across"
          name="picture"
          place=${this.layout}
          label=${texts.sizeOf.picture}
        ></vidno-divider>
        <div class="beside">
          <section class="listing" aria-label=${texts.listing}>
            <vidno-listing
              .trace=${this.trace}
              .view=${view}
              ?breakable=${this.breakable && !veiled}
            ></vidno-listing>
          </section>
          ${this.edited === null ? nothing : this.editor(this.edited, view)}
          ${isShown('side', this.layout, this.side, this.parts.length > 0) ? this.sidePanel(view, check, history, veiled) : nothing}
        </div>
      </div>
      <p class="heard pointed-at" aria-live="polite">${sayThing(view)}</p>
      ${this.presenter.curtain()}
      <vidno-keys
        .texts=${texts}
        ?flat=${!hasSolid(view)}
        @vidno-keys=${() => this.requestUpdate()}
      ></vidno-keys>
    `;
  }

  /** The panels about a step in a lesson, which has no choice between panels. */
  private asides(view: View): TemplateResult | typeof nothing {
    if (!this.isFull || this.presenting || this.layout !== 'lesson') return nothing;
    const sides: readonly Side[] = [
      'exact',
      ...(hasSolid(view) ? ['solid' as const] : []),
      'predict',
    ];
    return html`<div class="asides">${sides.map((side) => this.aside(side, view))}</div>`;
  }

  private aside(side: Side, view: View): TemplateResult {
    const name = sideName(side, view);
    const open = (): void => (side === 'predict' ? this.predictor.next() : this.toggleSide(side));
    return html`<button
      class=${side}
      aria-pressed=${this.side === side ? 'true' : 'false'}
      title=${withKey(name, sideKeys[side] ?? '')}
      @click=${open}
    >
      ${name}
    </button>`;
  }

  /** The result, at the end of the run. */
  private verdict(trace: Trace, view: View): TemplateResult | typeof nothing {
    const said = verdictOn(trace, view, this.exact, this.checkOf(trace));
    return said === null ? nothing : html`<strong class="verdict">${said}</strong>`;
  }

  /** The scene while it is edited. */
  private get edited(): Editing | null {
    return this.isEdited ? this.editing : null;
  }

  private editor(editing: Editing, { texts: say }: View): TemplateResult {
    return html`<vidno-divider
        class="under"
        name="scene"
        place=${this.layout}
        label=${say.sizeOf.scene}
      ></vidno-divider>
      <section class="scene" aria-label=${texts[this.language].scene.scene}>
        <vidno-scene-panel
          .editing=${editing}
          .language=${this.language}
          .link=${this.link}
          ?linked=${this.linked}
          @close=${() => this.turnEditor()}
        ></vidno-scene-panel>
      </section>`;
  }

  private sidePanel(
    view: View,
    check: Check,
    history: History | null,
    veiled: boolean,
  ): TemplateResult {
    const { texts } = view;
    return html`<vidno-divider
        class="between"
        name="listing"
        place=${this.layout}
        label=${texts.sizeOf.listing}
      ></vidno-divider>
      <section class="side ${this.side}" aria-label=${sideName(this.side, view)}>
        <vidno-side
          .view=${view}
          .trace=${this.trace}
          .maps=${this.maps}
          .check=${check}
          .history=${history}
          .bookmarks=${this.bookmarks}
          .linked=${this.linked}
          .side=${this.side}
          .sought=${this.sought}
          ?veiled=${veiled}
          .parts=${this.layout === 'lesson' ? this.parts : null}
          .predictor=${this.predictor}
          ?bare=${this.presenting}
          @side=${({ detail }: CustomEvent<Side>) => (this.side = detail)}
          @command=${this.onCommand}
          @search=${({ detail }: CustomEvent<string>) => (this.sought = detail)}
          @hits=${({ detail }: CustomEvent<readonly number[]>) => (this.hits = detail)}
          @forget=${() => this.chosen.choose(null)}
          .edited=${this.editing === null ? null : this.isEdited}
          @edit=${() => this.turnEditor()}
        ></vidno-side>
      </section>`;
  }

  /** Points at the next or previous thing of the step. */
  point(by: 1 | -1): void {
    if (this.view) this.pointing.move(by, this.view);
  }

  protected override steer(command: Command): void {
    if (command.do === 'bookmarks') this.keepBookmarks(command.bookmarks);
    else super.steer(command);
  }
}

/** The terms of a sentence. A polygon may be named like one. */
const termsIn = ({ language, header }: View): FirstTerms =>
  new FirstTerms(language, (word) => header.scene.byId.has(word));

declare global {
  interface HTMLElementTagNameMap {
    'vidno-player': PlayerElement;
  }
}
