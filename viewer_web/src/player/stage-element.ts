import { html } from 'lit';
import type { TemplateResult } from 'lit';
import { property, query } from 'lit/decorators.js';
import type { View } from '../algorithm/view.js';
import { Announcer } from '../elements/announcer.js';
import { Keyboard } from '../elements/keyboard.js';
import type { Actions } from '../elements/keyboard.js';
import '../elements/keys.js';
import type { KeysElement } from '../elements/keys.js';
import { ownCheck } from '../exactness/truth.js';
import type { Check } from '../exactness/truth.js';
import type { History } from '../history/history.js';
import { texts } from '../i18n/index.js';
import { isLanguage } from '../language/language.js';
import type { Language } from '../language/language.js';
import type { Trace } from '../replay/trace.js';
import '../strip/transport.js';
import type { TransportElement } from '../strip/transport.js';
import type { Bookmarks } from '../time/bookmarks.js';
import type { Command } from '../time/travel.js';
import '../time/travel.js';
import { Presenter } from './presenter.js';
import { TimedElement } from './timed.js';

/** What the controls leave out: moves through the run, or what shows the future. */
interface LeftOut {
  readonly plain: boolean;
  /** Everything but the most common moves. */
  readonly brief: boolean;
  readonly veiled: boolean;
}

/** The search results in the outline. */
interface Found {
  readonly hits: readonly number[];
}

/** Shows one run or two, in a language, controlled by keys, and can present them to an audience. */
export abstract class StageElement extends TimedElement {
  @property() override lang = 'en';
  /** Whether the view is adapted to a projector; an event `vidno-present` reports a change by keys. */
  @property({ type: Boolean, reflect: true }) presenting = false;
  /**
   * How decisions are known to be right or wrong; null if the page cannot check runs. An event `vidno-check` asks for a
   * check.
   */
  @property({ attribute: false }) check: Check | null = null;
  @property({ attribute: false }) bookmarks: Bookmarks = [];
  @query('vidno-keys') readonly keys!: KeysElement;
  @query('vidno-transport') private transport!: TransportElement;
  readonly presenter = new Presenter(this);
  private readonly keyboard = new Keyboard(this, (event) => this.actions(event), true);
  readonly announcer = new Announcer(this);

  /** The current actions of keys. */
  protected abstract actions(event: KeyboardEvent): Actions;

  checkOf(trace: Trace): Check {
    return this.check ?? ownCheck(trace);
  }

  /** The play button and the moves through the run. */
  protected playControls(
    view: View,
    check: Check,
    history: History | null,
    { plain, brief, veiled, hits }: LeftOut & Found = {
      plain: false,
      brief: false,
      veiled: false,
      hits: [],
    },
  ): TemplateResult {
    return html`<vidno-transport
      .trace=${this.trace}
      .view=${view}
      .check=${check}
      .bookmarks=${this.bookmarks}
      .hits=${hits}
      .first=${this.first}
      .last=${this.last}
      ?bounded=${this.isBounded}
      ?plain=${plain}
      ?brief=${brief}
      ?veiled=${veiled}
      .playing=${this.clock.playing}
      .speed=${this.clock.speed}
      @command=${this.onCommand}
    >
      <vidno-travel
        .trace=${this.trace}
        .view=${view}
        .check=${check}
        .history=${history}
        .bookmarks=${this.bookmarks}
        ?brief=${brief}
        @command=${this.onCommand}
      ></vidno-travel>
    </vidno-transport>`;
  }

  protected onCommand({ detail }: CustomEvent<Command>): void {
    this.steer(detail);
  }

  get language(): Language {
    return isLanguage(this.lang) ? this.lang : 'en';
  }

  showKeys(): void {
    this.keys.toggle();
  }

  /** Moves the focus to the play button. */
  focusPlay(): void {
    this.transport.focusPlay();
  }

  /** Starts or ends the presentation. */
  present(on: boolean): void {
    this.presenting = on;
    const { news } = texts[this.language].page;
    this.announcer.say(on ? news.presented : news.notPresented);
    this.dispatchEvent(new CustomEvent('vidno-present', { detail: on }));
  }

  /** Runs the action of a key; the page passes on keys that were pressed outside. */
  handleKey(event: KeyboardEvent): void {
    this.keyboard.handle(event);
  }
}
