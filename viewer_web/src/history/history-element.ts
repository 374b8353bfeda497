import { LitElement, html, nothing } from 'lit';
import type { PropertyValues, TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { classMap } from 'lit/directives/class-map.js';
import { repeat } from 'lit/directives/repeat.js';
import { polygonThing } from '../algorithm/pointed.js';
import { placesOf } from '../algorithm/shows.js';
import { numbersOf } from '../algorithm/view.js';
import type { View } from '../algorithm/view.js';
import { liveKey } from '../base/key-map.js';
import { polygonName, swatch } from '../elements/parts.js';
import { statement } from '../elements/statement.js';
import { sentencesOf } from '../language/stated.js';
import { base, hiddenStyle } from '../elements/theme.js';
import { texts } from '../i18n/index.js';
import type { HistoryTexts } from '../language/texts.js';
import { Follower } from '../picture/in-sight.js';
import type { Pixel } from '../picture/pixel.js';
import { toColor } from '../replay/screen.js';
import type { Command } from '../time/travel.js';
import type { Entry } from './entry.js';
import { grouped, shownAround } from './groups.js';
import type { Group } from './groups.js';
import type { History } from './history.js';
import { historyStyle } from './history.style.js';
import './why-element.js';

const signs = { pass: '✓', fail: '✗', wrong: '!', note: '·' } as const;

/** Every step that concerned the chosen pixel, each with a link to the step. */
@customElement('vidno-history')
export class HistoryElement extends LitElement {
  static override styles = [base, hiddenStyle, historyStyle];

  @property({ attribute: false }) view!: View;
  @property({ attribute: false }) history: History | null = null;
  /** The entry that is in sight: first the answer, then that of the step. */
  private centre = -1;
  private reached = -1;
  private length = -1;
  private shownStep = -1;

  private get texts(): HistoryTexts {
    return placesOf(this.view);
  }

  override willUpdate(changed: PropertyValues<this>): void {
    const { history, view } = this;
    if (history === null) return;
    this.reached = history.indexAt(view.step);
    const fresh = changed.has('history') || this.length !== history.entries.length;
    if (fresh) this.centre = history.indexAt(history.painter?.step ?? view.step);
    else if (view.step !== this.shownStep) this.centre = this.reached;
    this.length = history.entries.length;
    this.shownStep = view.step;
  }

  override render(): TemplateResult {
    const { history } = this;
    if (history === null) return html`<p class="hint">${this.texts.hint(liveKey('P'))}</p>`;
    const { entries } = history;
    const [first, end] = shownAround(this.centre, entries.length);
    return html`
      ${this.why(history)}
      <vidno-why
        .history=${history}
        .language=${this.view.language}
        .pointed=${this.view.pointed}
      ></vidno-why>
      ${this.head(history)}
      <div
        class="entries"
        aria-busy=${history.complete ? 'false' : 'true'}
        role="region"
        aria-label=${this.texts.entries}
        @keydown=${this.onKey}
      >
        ${this.more(entries[first - 1], this.texts.earlier(first))}
        ${grouped(entries.slice(first, end)).map((group) => this.group(group, history))}
        ${this.more(entries[end], this.texts.later(entries.length - end))}
        ${history.complete ? nothing : html`<p class="hint">${this.texts.reading}</p>`}
      </div>
    `;
  }

  private head({ painter, pixel }: History): TemplateResult {
    return html`<div class="head">
      ${this.view.columns === null ? this.color(pixel) : nothing}
      <button
        class="last"
        ?disabled=${painter === null}
        @click=${() => this.goTo(painter?.step ?? 0)}
      >
        ${painter === null ? this.texts.unpainted : this.texts.painted(painter.step)}
      </button>
      <button
        class="forget"
        aria-label=${this.texts.forget}
        title=${this.texts.forget}
        @click=${() => this.dispatchEvent(new CustomEvent('forget'))}
      >
        ✕
      </button>
    </div>`;
  }

  private color([x, y]: Pixel): TemplateResult {
    const { screen, header } = this.view;
    const { area } = header.scene;
    const color = toColor(screen.picture.at(x - area.x, y - area.y));
    return html`<p class="color" title=${color}>${swatch(color)}</p>`;
  }

  private more(next: Entry | undefined, label: string): TemplateResult | typeof nothing {
    if (next === undefined) return nothing;
    return html`<button class="more" @click=${() => this.goTo(next.step)}>${label}</button>`;
  }

  private group({ under, entries }: Group, history: History): TemplateResult {
    return html`<section>
      ${under === null ? nothing : html`<h3>${this.heading(under)}</h3>`}
      <ol>
        ${repeat(
          entries,
          ({ step }) => step,
          (entry) => this.entry(entry, history),
        )}
      </ol>
    </section>`;
  }

  private heading(under: NonNullable<Group['under']>): unknown {
    const { texts: page } = this.view;
    if (typeof under === 'string') return polygonName(under, this.view);
    if (typeof under === 'number') return texts[this.view.language].curves.curve(under);
    return html`${page.window}
      <span class="number">${numbersOf(this.view).windowText(under)}</span>`;
  }

  private entry(entry: Entry, history: History): TemplateResult {
    const { step, outcome } = entry;
    const { view } = this;
    const now = step === view.step;
    const reached = step === history.entries[this.reached]?.step;
    const place = now ? 'now' : reached ? 'reached' : step > view.step ? 'later' : '';
    const inSight = step === history.entries[this.centre]?.step;
    const painter = entry === history.painter;
    const said = this.texts.outcomes[outcome];
    const thing = 'polygon' in entry.event ? polygonThing(entry.event.polygon) : null;
    const pointed = thing !== null && thing === view.pointed;
    const classes = { [outcome]: true, [place]: place !== '', painter, pointed };
    return html`<li class=${classMap(classes)} data-step=${step} data-thing=${thing ?? nothing}>
      <button
        tabindex=${inSight ? 0 : -1}
        aria-current=${now ? 'step' : nothing}
        @click=${() => this.goTo(step)}
      >
        <span class="sign" aria-hidden="true" title=${said}>${this.sign(entry)}</span>
        <span class="said"
          >${said === '' ? nothing : html`<span class="heard">${said}: </span>`}${statement(history.sentence(entry, view.language))}</span
        >
        <span class="step number">${step}</span>
      </button>
    </li>`;
  }

  /** Why the pixel has its colour, before what concerned it. */
  private why(history: History): TemplateResult | typeof nothing {
    const { painter } = history;
    const { columns, language, step } = this.view;
    if (painter === null || columns !== null) return nothing;
    // At the steps before it was painted it says so in more words, which have their room from the start.
    const longest = sentencesOf(history.why(painter, language, 0)).join(' ');
    return html`<p class="why" data-longest=${longest}>
      <span>${statement(history.why(painter, language, step))}</span>
    </p>`;
  }

  private sign({ outcome, event, under }: Entry): unknown {
    if (outcome !== 'paint') return signs[outcome];
    if ('color' in event && event.color) return swatch(event.color);
    if (event.e === 'draw_line') return '━';
    return swatch(this.view.header.scene.byId.get(String(under))?.color ?? '');
  }

  private goTo(step: number): void {
    this.dispatchEvent(new CustomEvent<Command>('command', { detail: { do: 'seek', step } }));
  }

  /** Tab reaches only one entry; the arrow keys move between entries. */
  private onKey(event: KeyboardEvent): void {
    const by = { ArrowUp: -1, ArrowDown: 1 }[event.key];
    if (by === undefined) return;
    const all = [...this.renderRoot.querySelectorAll<HTMLElement>('.entries button')];
    const at = all.findIndex((button) => button.matches(':focus'));
    all[at + by]?.focus();
    event.preventDefault();
  }

  override updated(): void {
    this.follow();
  }

  private followed = '';
  private readonly follower = new Follower();

  /** Scrolls within the list, and only when another entry has to be in sight. */
  private follow(): void {
    const step = this.history?.entries[this.centre]?.step;
    const goal = `${this.history?.pixel.join() ?? ''} ${step ?? ''}`;
    if (step === undefined || goal === this.followed) return;
    this.followed = goal;
    const box = this.renderRoot.querySelector('.entries');
    const entry = this.renderRoot.querySelector(`[data-step="${step}"]`);
    if (!(box instanceof HTMLElement) || !(entry instanceof HTMLElement)) return;
    this.follower.follow(null, null); // the element may have shown another entry before
    this.follower.follow(box, entry, 32);
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'vidno-history': HistoryElement;
  }
}
