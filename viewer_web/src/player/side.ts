import { LitElement, css, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property, query } from 'lit/decorators.js';
import type { StatePart } from '../algorithm/shows.js';
import { placesOf, showsOf } from '../algorithm/shows.js';
import type { View } from '../algorithm/view.js';
import { withKey } from '../base/key-map.js';
import { base } from '../elements/theme.js';
import '../exactness/exactness-element.js';
import type { Check } from '../exactness/truth.js';
import type { History } from '../history/history.js';
import '../history/history-element.js';
import { hasSolid, sideKeys, sideName } from '../history/side-name.js';
import type { Side } from '../history/side-name.js';
import { texts } from '../i18n/index.js';
import '../outline/outline-element.js';
import type { OutlineElement } from '../outline/outline-element.js';
import '../predict/predict-element.js';
import type { Predictor } from '../predict/predictor.js';
import type { Trace } from '../replay/trace.js';
import type { SignMaps } from '../run/sign-maps.js';
import type { Bookmarks } from '../time/bookmarks.js';
import '../time/bookmarks-element.js';
import type { BookmarksElement } from '../time/bookmarks-element.js';

/** One of the panels: the state of the procedure, the history of a pixel, the right answer to a decision, and so on. */
@customElement('vidno-side')
export class SideElement extends LitElement {
  static override styles = [
    base,
    css`
      :host {
        display: flex;
        flex-direction: column;
        min-height: 0;
      }
      :host > :not(.choice) {
        flex: 1;
        min-height: 0;
      }
      .choice {
        container-type: inline-size;
        display: flex;
        flex: none;
        flex-wrap: wrap;
        padding: 0.15rem 0.15rem 0;
        border-bottom: 1px solid var(--line);
        /* A part of the panel and, on a phone, the dock. */
        scroll-margin-bottom: 20rem;
      }
      :host([bare]) .choice {
        display: none;
      }
      button {
        min-width: 1.5rem;
        min-height: 1.9rem;
        padding: 0.1rem 0.375rem 0;
        border: 0;
        border-bottom: 3px solid transparent;
        border-radius: 0;
        background: none;
        color: var(--soft);
        font-size: 0.8125rem;
        font-weight: 600;
        white-space: nowrap;
      }
      button[aria-pressed='true'] {
        border-color: var(--accent);
        color: var(--ink);
      }
      /* Every word in one row, or in two low ones, so that the panel keeps its height. */
      @container (max-width: 36rem) {
        button {
          min-height: 1.6rem;
          padding-inline: 0.225rem;
          font-size: 0.75rem;
          font-weight: 400;
        }
        .number {
          display: none;
        }
      }
      @container (max-width: 23rem) {
        button {
          padding-inline: 0.15rem;
          font-size: 0.6875rem;
        }
      }
      .opened {
        align-items: center;
        justify-content: space-between;
        padding: 0 0.3rem 0 0.75rem;
      }
      .opened button {
        width: 1.9rem;
      }
      @media print {
        .choice {
          display: none;
        }
      }
      button:focus-visible {
        outline-offset: -4px;
      }
    `,
  ];

  @property({ attribute: false }) view!: View;
  @property({ attribute: false }) trace!: Trace;
  @property({ attribute: false }) maps: SignMaps | null = null;
  @property({ attribute: false }) check!: Check;
  @property({ attribute: false }) history: History | null = null;
  @property({ attribute: false }) bookmarks: Bookmarks = [];
  @property({ type: Boolean }) linked = false;
  /** The query of the outline's search. */
  @property({ attribute: false }) sought = '';
  /** Whether everything after the step is hidden. */
  @property({ type: Boolean }) veiled = false;
  @property({ attribute: false }) side: Side = 'state';
  /** The parts of the state that a lesson asks for. Then there is no choice between panels, but a way back. */
  @property({ attribute: false }) parts: readonly StatePart[] | null = null;
  /** Without the choice between panels. */
  @property({ type: Boolean, reflect: true }) bare = false;
  /** Whether the scene is being edited beside it; null where it cannot be. An event `edit` asks to change that. */
  @property({ attribute: false }) edited: boolean | null = null;
  @property({ attribute: false }) predictor!: Predictor;
  @query('vidno-bookmarks') private list!: BookmarksElement | null;
  @query('vidno-outline') private outline!: OutlineElement | null;

  /** Bookmarks the current step, or moves the focus to the list. The bookmarks must be the open panel. */
  async bookmark(way: 'mark' | 'enter'): Promise<void> {
    await this.updateComplete;
    await this.list?.[way]();
  }

  /** Moves the focus to the outline, which must be the open panel. */
  async enterOutline(): Promise<void> {
    await this.updateComplete;
    await this.outline?.updateComplete;
    this.outline?.focus();
  }

  /** On a small screen the panels are below the picture. */
  async bringIntoSight(): Promise<void> {
    await this.updateComplete;
    this.renderRoot.querySelector('.choice')?.scrollIntoView({ block: 'nearest' });
  }

  override render(): TemplateResult {
    const { view, history } = this;
    const name = (side: Side): string => sideName(side, view);
    const pixel = history === null ? name('pixel') : placesOf(view).at(...history.pixel);
    if (this.parts !== null) return html`${this.name()} ${this.panel()}`;
    return html`
      <div class="choice" role="group">
        ${this.button('state', name('state'))} ${this.button('pixel', pixel)}
        ${this.button('exact', name('exact'))}
        ${hasSolid(view) ? this.button('solid', name('solid')) : nothing}
        ${this.edited === null ? nothing : this.editor(this.edited)}
        ${this.button('outline', name('outline'))} ${this.button('predict', name('predict'))}
        ${this.button('bookmarks', name('bookmarks'), this.count(name('bookmarks')))}
      </div>
      ${this.panel()}
    `;
  }

  /** The name of the panel in place of the lesson's parts of the state, with a button to return to them. */
  private name(): TemplateResult | typeof nothing {
    const { view, shown } = this;
    if (shown === 'state') return nothing;
    const { close } = view.texts;
    return html`<div class="choice opened">
      <h2>${sideName(shown, view)}</h2>
      <button aria-label=${close} title=${close} @click=${() => this.choose('state')}>✕</button>
    </div>`;
  }

  private choose(detail: Side): void {
    this.dispatchEvent(new CustomEvent('side', { detail }));
  }

  private count(name: string): TemplateResult {
    const { length } = this.bookmarks;
    return html`${name}${length === 0 ? nothing : html` <span class="number">${length}</span>`}`;
  }

  /** The open panel; the state replaces one that the run does not have. */
  private get shown(): Side {
    return this.side === 'solid' && !hasSolid(this.view) ? 'state' : this.side;
  }

  private panel(): TemplateResult {
    const { view, history } = this;
    switch (this.shown) {
      case 'pixel':
        return html`<vidno-history
          .view=${view}
          .history=${history}
          @command=${this.passOn}
          @forget=${this.passOn}
        ></vidno-history>`;
      case 'exact':
        return html`<vidno-exactness
          .view=${view}
          .trace=${this.trace}
          .maps=${this.maps}
          .check=${this.check}
          ?bare=${this.bare}
        ></vidno-exactness>`;
      case 'bookmarks':
        return html`<vidno-bookmarks
          .view=${view}
          .bookmarks=${this.bookmarks}
          .linked=${this.linked}
          @command=${this.passOn}
        ></vidno-bookmarks>`;
      case 'predict':
        return html`<vidno-predict
          .view=${view}
          .predictor=${this.predictor}
          @command=${this.passOn}
        ></vidno-predict>`;
      case 'solid':
        return html`<vidno-solid .view=${view} ?bare=${this.bare}></vidno-solid>`;
      case 'outline':
        return html`<vidno-outline
          .trace=${this.trace}
          .view=${view}
          .sought=${this.sought}
          ?veiled=${this.veiled}
          @command=${this.passOn}
          @search=${this.passOn}
          @hits=${this.passOn}
        ></vidno-outline>`;
      case 'state':
        return this.state();
    }
  }

  /** Beside the editor and on a projector the parts of the state have little room: they scroll, also by keyboard. */
  override updated(): void {
    const panel = this.renderRoot.lastElementChild;
    if (!(panel instanceof HTMLElement)) return;
    if (this.bare || (this.parts !== null && this.edited === true)) panel.tabIndex = 0;
    else panel.removeAttribute('tabindex');
  }

  private state(): TemplateResult {
    return showsOf(this.view).state(this.view, this.parts);
  }

  private editor(isOn: boolean): TemplateResult {
    const { scene } = texts[this.view.language];
    return html`<button
      class="scene"
      aria-pressed=${isOn ? 'true' : 'false'}
      title=${withKey(scene.scene, 'E')}
      @click=${() => this.dispatchEvent(new CustomEvent('edit'))}
    >
      ${scene.scene}
    </button>`;
  }

  private button(
    side: Side,
    label: string,
    shown: string | TemplateResult = label,
  ): TemplateResult {
    const key = sideKeys[side];
    return html`<button
      class=${side}
      aria-pressed=${side === this.shown ? 'true' : 'false'}
      aria-label=${typeof shown === 'string' ? nothing : `${label}: ${this.bookmarks.length}`}
      title=${key === undefined ? label : withKey(label, key)}
      @click=${() => this.choose(side)}
    >
      ${shown}
    </button>`;
  }

  private passOn({ type, detail }: CustomEvent<unknown>): void {
    this.dispatchEvent(new CustomEvent(type, { detail }));
  }
}
