import { LitElement, html, nothing } from 'lit';
import type { PropertyValues, TemplateResult } from 'lit';
import { customElement, property, query, state } from 'lit/decorators.js';
import { historyOf } from '../history/history.js';
import type { History } from '../history/history.js';
import { isLanguage } from '../i18n/language.js';
import type { Language } from '../i18n/language.js';
import { isOther } from '../picture/pixel.js';
import type { Pixel } from '../picture/pixel.js';
import { canonical } from '../state/canonical.js';
import type { Trace } from '../trace/trace.js';
import { viewOf } from '../view.js';
import type { View } from '../view.js';
import { Clock } from './clock.js';
import { takesKey } from './keyboard.js';
import './keys.js';
import type { KeysElement } from './keys.js';
import './legend.js';
import './listing.js';
import type { PictureElement } from './picture.js';
import './picture.js';
import { playerStyle } from './player.style.js';
import './side.js';
import type { Side } from './side.js';
import { base, tokens } from './theme.js';
import './transport.js';
import { speeds } from './transport.js';
import type { Command } from './transport.js';
import './travel.js';
import type { TravelElement } from './travel.js';

const mostPerFrame = 60;

/**
 * Replays a trace. Set `trace` and `length`; `step`, `pixel` and `lang` may be set and change with the controls. Each step that
 * is shown is told by an event `vidno-step`, each pixel that is chosen by `vidno-pixel`.
 */
@customElement('vidno-player')
export class PlayerElement extends LitElement {
  static override styles = [tokens, base, playerStyle];

  @property({ attribute: false }) trace: Trace | null = null;
  /** How many steps of the trace are there: more and more while it is read. */
  @property({ attribute: false }) length = 0;
  @property({ type: Number }) step = 0;
  @property({ attribute: false, hasChanged: isOther }) pixel: Pixel | null = null;
  @property() override lang = 'en';
  @state() private playing = false;
  @state() private speed = 5;
  @state() private side: Side = 'state';
  @query('vidno-keys') private keys!: KeysElement;
  @query('vidno-picture') private picture!: PictureElement;
  @query('vidno-travel') private travel!: TravelElement;
  private view: View | null = null;
  private history: History | null = null;
  private readonly clock = new Clock(
    () => this.speed,
    (steps) => this.advance(steps),
  );

  /** Shows the state after the first `step` events. */
  seek(step: number): void {
    this.step = step;
  }

  /** The state that is shown, in the form in which readers of a trace are compared. */
  canonicalState(): unknown {
    if (this.trace === null) return null;
    const { header, timeline } = this.trace;
    return canonical(timeline.seek(this.clamped(this.step)), header);
  }

  togglePlay(): void {
    if (this.playing) this.pause();
    else this.play();
  }

  private play(): void {
    if (this.step >= this.length) this.step = 0;
    this.playing = true;
    this.clock.start();
  }

  private pause(): void {
    this.playing = false;
    this.clock.stop();
  }

  private advance(steps: number): void {
    if (steps > 0) this.step = this.clamped(this.step + steps);
    if (this.step >= this.length && this.trace?.complete !== false) this.pause();
  }

  private clamped(step: number): number {
    return Math.min(Math.max(0, Math.trunc(step) || 0), this.length);
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.addEventListener('keydown', this.onKey);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.removeEventListener('keydown', this.onKey);
    this.pause();
  }

  override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has('trace')) this.pause();
    this.step = this.clamped(this.step);
    const language: Language = isLanguage(this.lang) ? this.lang : 'en';
    if (changed.has('trace') || changed.has('pixel')) this.openHistory();
    this.readHistory();
    const pixel = this.history?.pixel ?? null;
    this.view = this.trace && viewOf(this.trace, this.step, language, pixel);
  }

  private openHistory(): void {
    this.history = historyOf(this.trace, this.pixel);
    this.side = this.history === null ? 'state' : 'pixel';
  }

  /** Goes on with the history of the pixel, for as long as a frame allows. */
  private readHistory(): void {
    if (this.history === null || this.history.read(mostPerFrame)) return;
    requestAnimationFrame(() => this.requestUpdate());
  }

  private choosePixel(pixel: Pixel | null): void {
    this.pixel = pixel;
    this.side = pixel === null ? 'state' : 'pixel';
    this.dispatchEvent(new CustomEvent('vidno-pixel', { detail: pixel }));
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
          <vidno-picture
            .view=${view}
            @pixel=${({ detail }: CustomEvent<Pixel>) => this.choosePixel(detail)}
          ></vidno-picture>
          <vidno-legend .view=${view}></vidno-legend>
        </section>
        <section class="listing" aria-label=${texts.listing}>
          <vidno-listing .view=${view}></vidno-listing>
        </section>
        <section class="side ${this.side}" aria-label=${texts.state}>
          <vidno-side
            .view=${view}
            .history=${this.history}
            .side=${this.side}
            @side=${({ detail }: CustomEvent<Side>) => (this.side = detail)}
            @command=${this.onCommand}
            @forget=${() => this.choosePixel(null)}
          ></vidno-side>
        </section>
      </div>
      <div class="dock">
        <p class="sentence" aria-live=${this.playing ? 'off' : 'polite'} aria-atomic="true">
          <span class="at">${view.event?.at ?? '·'}</span><span>${view.sentence}</span>
        </p>
        <vidno-transport
          .view=${view}
          .playing=${this.playing}
          .speed=${this.speed}
          @command=${this.onCommand}
        ></vidno-transport>
        <vidno-travel
          .trace=${this.trace}
          .view=${view}
          .history=${this.history}
          @command=${this.onCommand}
        ></vidno-travel>
      </div>
      <vidno-keys .texts=${texts}></vidno-keys>
    `;
  }

  showKeys(): void {
    this.keys.toggle();
  }

  private onCommand({ detail }: CustomEvent<Command>): void {
    if (detail.do === 'play') this.togglePlay();
    else if (detail.do === 'speed') this.speed = detail.speed;
    else this.moveTo(detail.step);
  }

  private moveTo(step: number): void {
    this.pause();
    this.step = this.clamped(step);
  }

  private readonly onKey = (event: KeyboardEvent): void => this.handleKey(event);

  /** Does what a key means; the page passes on keys that were pressed outside the player. */
  handleKey(event: KeyboardEvent): void {
    if (this.trace === null || event.defaultPrevented) return;
    if (event.ctrlKey || event.metaKey || event.altKey || takesKey(event)) return;
    const act = this.actionOf(event);
    if (act === null || (this.keys.open && event.key !== '?')) return;
    event.preventDefault();
    act();
  }

  private actionOf({ key, code, shiftKey }: KeyboardEvent): (() => void) | null {
    const by = shiftKey ? 10 : 1;
    const way = shiftKey ? 'out' : 'over';
    const actions: Readonly<Record<string, () => void>> = {
      ArrowRight: () => this.moveTo(this.step + by),
      ArrowLeft: () => this.moveTo(this.step - by),
      Home: () => this.moveTo(0),
      End: () => this.moveTo(this.length),
      ' ': () => this.togglePlay(),
      '+': () => this.changeSpeed(1),
      '=': () => this.changeSpeed(1),
      '-': () => this.changeSpeed(-1),
      '?': () => this.showKeys(),
      BracketLeft: () => this.travel.call(way, -1),
      BracketRight: () => this.travel.call(way, 1),
      Comma: () => this.travel.next(-1),
      Period: () => this.travel.next(1),
      KeyP: () => this.picture.startChoosing(),
    };
    return actions[key] ?? actions[code] ?? null;
  }

  private changeSpeed(by: number): void {
    const now = speeds.findIndex((speed) => speed >= this.speed);
    this.speed = speeds[now + by] ?? this.speed;
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'vidno-player': PlayerElement;
  }
}
