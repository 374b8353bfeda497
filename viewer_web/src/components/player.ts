import { LitElement, html, nothing } from 'lit';
import type { PropertyValues, TemplateResult } from 'lit';
import { customElement, property, query } from 'lit/decorators.js';
import { historyOf } from '../history/history.js';
import type { History } from '../history/history.js';
import { isLanguage } from '../i18n/language.js';
import type { Language } from '../i18n/language.js';
import type { Exact, Layer } from '../picture/layers.js';
import { isOther } from '../picture/pixel.js';
import type { Pixel } from '../picture/pixel.js';
import { canonical } from '../state/canonical.js';
import type { Editing } from '../live/editor.js';
import type { LinkMade } from '../live/live.js';
import { bookmarksUpTo } from '../time/bookmarks.js';
import type { Bookmarks } from '../time/bookmarks.js';
import type { Trace } from '../trace/trace.js';
import { viewOf } from '../view.js';
import type { View } from '../view.js';
import { Clock } from './clock.js';
import { Keyboard } from './keyboard.js';
import type { Actions } from './keyboard.js';
import './keys.js';
import type { KeysElement } from './keys.js';
import './listing.js';
import { isOnlyEdited } from './only-edited.js';
import './picture-panel.js';
import type { PicturePanelElement } from './picture-panel.js';
import { playerStyle } from './player.style.js';
import { ReadOn } from './read-on.js';
import './side.js';
import type { Side, SideElement } from './side.js';
import { base, tokens } from './theme.js';
import './transport.js';
import type { Command } from './transport.js';
import './travel.js';
import type { TravelElement } from './travel.js';

const mostPerFrame = 60;

/**
 * Replays a trace. Set `trace` and `length`; `step`, `pixel`, `bookmarks` and `lang` may be set and change with the
 * controls. Each step that is shown is told by an event `vidno-step`, each pixel that is chosen by `vidno-pixel`, and
 * the bookmarks, when they change, by `vidno-bookmarks`; `linked` says that these are kept in the page's address.
 */
@customElement('vidno-player')
export class PlayerElement extends LitElement {
  static override styles = [tokens, base, playerStyle];

  @property({ attribute: false }) trace: Trace | null = null;
  /** How many steps of the trace are there: more and more while it is read. */
  @property({ attribute: false }) length = 0;
  @property({ type: Number }) step = 0;
  @property({ attribute: false, hasChanged: isOther }) pixel: Pixel | null = null;
  @property({ attribute: false }) bookmarks: Bookmarks = [];
  /** What the pixels show, if the trace has it; another layer is asked for by `vidno-layer`. */
  @property({ attribute: false }) layer: Layer = 'picture';
  /** The exact picture of the scene. */
  @property({ attribute: false }) exact: Exact = null;
  @property({ type: Boolean }) linked = false;
  @property() override lang = 'en';
  /** The scene, if it may be changed; what is to be done with it is told by `vidno-act`, `vidno-save`, `vidno-link`. */
  @property({ attribute: false }) editing: Editing | null = null;
  @property({ attribute: false }) link: LinkMade | null = null;
  /** The panel beside the listing. */
  @property({ attribute: false }) side: Side = 'state';
  @query('vidno-keys') private keys!: KeysElement;
  @query('vidno-picture-panel') private picture!: PicturePanelElement;
  @query('vidno-travel') private travel!: TravelElement;
  @query('vidno-side') private panel!: SideElement;
  private view: View | null = null;
  private history: History | null = null;
  private readonly clock = new Clock(this, (steps) => this.advance(steps));
  private readonly keyboard = new Keyboard(this, (event) => this.actionsAt(event));
  private readonly reader = new ReadOn(this, mostPerFrame);

  /** The state that is shown, in the form in which readers of a trace are compared. */
  canonicalState(): unknown {
    if (this.trace === null) return null;
    const { header, timeline } = this.trace;
    return canonical(timeline.seek(this.clamped(this.step)), header);
  }

  togglePlay(): void {
    if (this.clock.playing) this.clock.stop();
    else {
      if (this.step >= this.length) this.step = 0;
      this.clock.start();
    }
  }

  private advance(steps: number): void {
    if (steps > 0) this.step = this.clamped(this.step + steps);
    if (this.step >= this.length && this.trace?.complete !== false) this.clock.stop();
  }

  private clamped(step: number): number {
    return Math.min(Math.max(0, Math.trunc(step) || 0), this.length);
  }

  override willUpdate(changed: PropertyValues<this>): void {
    if (isOnlyEdited(changed)) return;
    if (changed.has('trace')) this.clock.stop();
    this.step = this.clamped(this.step);
    if (this.trace !== null) this.bookmarks = bookmarksUpTo(this.bookmarks, this.length);
    const language: Language = isLanguage(this.lang) ? this.lang : 'en';
    if (changed.has('trace') || changed.has('pixel')) this.openHistory(changed.has('pixel'));
    this.reader.read(this.history);
    const pixel = this.history?.pixel ?? null;
    this.view = this.trace && viewOf(this.trace, this.step, language, pixel);
  }

  /** While the scene is edited its panel stays, for each run is another trace. */
  private openHistory(isChosen: boolean): void {
    this.history = historyOf(this.trace, this.pixel);
    if (this.side === 'scene' && !isChosen) return;
    this.side = this.history === null ? 'state' : 'pixel';
  }

  private choosePixel(pixel: Pixel | null): void {
    this.pixel = pixel;
    this.side = pixel === null ? 'state' : 'pixel';
    this.dispatchEvent(new CustomEvent('vidno-pixel', { detail: pixel }));
  }

  private async openBookmarks(way: 'mark' | 'enter'): Promise<void> {
    this.side = 'bookmarks';
    await this.updateComplete;
    await this.panel.bookmark(way);
  }

  private keepBookmarks(bookmarks: Bookmarks): void {
    this.bookmarks = bookmarks;
    this.dispatchEvent(new CustomEvent('vidno-bookmarks', { detail: bookmarks }));
  }

  override updated(changed: PropertyValues<this>): void {
    if (changed.has('step') || changed.has('trace')) {
      this.dispatchEvent(new CustomEvent('vidno-step', { detail: this.step }));
    }
  }

  override render(): TemplateResult | typeof nothing {
    const { view } = this;
    if (view === null) return nothing;
    const { texts } = view;
    return html`
      <div class="panels">
        <section class="picture" aria-label=${texts.picture}>
          <vidno-picture-panel
            .view=${view}
            .editing=${this.side === 'scene' ? this.editing : null}
            .layer=${this.layer}
            .exact=${this.exact}
            @pixel=${({ detail }: CustomEvent<Pixel>) => this.choosePixel(detail)}
          ></vidno-picture-panel>
        </section>
        <section class="listing" aria-label=${texts.listing}>
          <vidno-listing .view=${view}></vidno-listing>
        </section>
        <section class="side ${this.side}" aria-label=${texts.state}>
          <vidno-side
            .view=${view}
            .history=${this.history}
            .bookmarks=${this.bookmarks}
            .linked=${this.linked}
            .side=${this.side}
            @side=${({ detail }: CustomEvent<Side>) => (this.side = detail)}
            @command=${this.onCommand}
            @forget=${() => this.choosePixel(null)}
            .editing=${this.editing}
            .link=${this.link}
          ></vidno-side>
        </section>
      </div>
      <div class="dock">
        <p class="sentence" aria-live=${this.clock.playing ? 'off' : 'polite'} aria-atomic="true">
          <span class="at">${view.event?.at ?? '·'}</span><span>${view.sentence}</span>
        </p>
        <vidno-transport
          .trace=${this.trace}
          .view=${view}
          .bookmarks=${this.bookmarks}
          .playing=${this.clock.playing}
          .speed=${this.clock.speed}
          @command=${this.onCommand}
        >
          <vidno-travel
            .trace=${this.trace}
            .view=${view}
            .history=${this.history}
            .bookmarks=${this.bookmarks}
            @command=${this.onCommand}
          ></vidno-travel>
        </vidno-transport>
      </div>
      <vidno-keys .texts=${texts}></vidno-keys>
    `;
  }

  showKeys(): void {
    this.keys.toggle();
  }

  private onCommand({ detail }: CustomEvent<Command>): void {
    if (detail.do === 'play') this.togglePlay();
    else if (detail.do === 'speed') this.clock.speed = detail.speed;
    else if (detail.do === 'bookmarks') this.keepBookmarks(detail.bookmarks);
    else this.moveTo(detail.step);
  }

  private moveTo(step: number): void {
    this.clock.stop();
    this.step = this.clamped(step);
  }

  /** Does what a key means; the page passes on keys that were pressed outside the player. */
  handleKey(event: KeyboardEvent): void {
    this.keyboard.handle(event);
  }

  private actionsAt({ shiftKey }: KeyboardEvent): Actions {
    if (this.trace === null) return {};
    const showKeys = { '?': () => this.showKeys() };
    if (this.keys.open) return showKeys;
    const by = shiftKey ? 10 : 1;
    const way = shiftKey ? 'out' : 'over';
    const goal = shiftKey ? 'bookmark' : undefined;
    return {
      ...showKeys,
      ArrowRight: () => this.moveTo(this.step + by),
      ArrowLeft: () => this.moveTo(this.step - by),
      Home: () => this.moveTo(0),
      End: () => this.moveTo(this.length),
      ' ': () => this.togglePlay(),
      '+': () => this.clock.changeSpeed(1),
      '=': () => this.clock.changeSpeed(1),
      '-': () => this.clock.changeSpeed(-1),
      BracketLeft: () => this.travel.call(way, -1),
      BracketRight: () => this.travel.call(way, 1),
      Comma: () => this.travel.next(-1, goal),
      Period: () => this.travel.next(1, goal),
      KeyB: () => void this.openBookmarks(shiftKey ? 'enter' : 'mark'),
      KeyL: () => this.picture.nextLayer(),
      KeyP: () => this.picture.startChoosing(),
    };
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'vidno-player': PlayerElement;
  }
}
