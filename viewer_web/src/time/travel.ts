import { LitElement, css, html, nothing, svg } from 'lit';
import type { PropertyValues, TemplateResult } from 'lit';
import { customElement, property, state } from 'lit/decorators.js';
import { guard } from 'lit/directives/guard.js';
import type { View } from '../algorithm/view.js';
import { withKey } from '../base/key-map.js';
import { base } from '../elements/theme.js';
import { askCheck } from '../exactness/truth.js';
import type { Check } from '../exactness/truth.js';
import { texts } from '../i18n/index.js';
import type { TravelTexts } from '../language/texts.js';
import type { Trace } from '../replay/trace.js';
import type { Bookmarks } from './bookmarks.js';
import { Calls } from './calls.js';
import type { Direction } from './calls.js';
import { Goals, around, goalsOf } from './goals.js';
import type { Followed, Goal, GoalName } from './goals.js';

/** The commands of the controls, which the player carries out. */
export type Command =
  | { readonly do: 'seek'; readonly step: number }
  | { readonly do: 'play' }
  | { readonly do: 'speed'; readonly speed: number }
  | { readonly do: 'bookmarks'; readonly bookmarks: Bookmarks };

const travelStyle = css`
  :host {
    display: flex;
    gap: 0.4rem 1.5rem;
    align-items: center;
    font-size: 0.8125rem;
  }
  .group {
    display: flex;
    gap: 0.25rem;
    align-items: center;
  }
  .name {
    margin-right: 0.25rem;
    color: var(--soft);
    white-space: nowrap;
  }
  button {
    display: grid;
    flex: none;
    place-items: center;
    width: 2.25rem;
    height: 2rem;
    padding: 0;
  }
  button[aria-disabled='true'] {
    color: var(--soft);
    opacity: 0.55;
  }
  svg {
    width: 1.25rem;
    height: 1.25rem;
    fill: none;
    stroke: currentColor;
    stroke-width: 1.75;
    stroke-linecap: round;
    stroke-linejoin: round;
  }
  .back svg {
    transform: scaleX(-1);
  }
  .goal {
    flex: 1;
    min-width: 0;
  }
  select {
    width: 15rem;
    min-width: 0;
    padding: 0 0.3rem;
    text-overflow: ellipsis;
  }
  .count {
    min-width: 5rem;
    color: var(--soft);
  }
  :host([brief]) .count {
    display: none;
  }
  :host([brief]) {
    gap: 0.25rem;
  }
  :host([brief]) > button {
    visibility: var(--quiet, visible);
  }
  :host([brief]) select {
    width: 11rem;
  }
  @container (max-width: 920px) {
    :host([brief]) select {
      width: 7rem;
    }
    :host([brief]) .name {
      display: none;
    }
  }
  /* Here every button has a border. */
  @media (forced-colors: active) {
    :host([brief]) select {
      width: 7.5rem;
    }
  }
  @container (max-width: 1100px) {
    :host {
      gap: 1rem;
    }
    .group:not(.goal) .name {
      display: none;
    }
  }
  @container (max-width: 960px) {
    .count {
      display: none;
    }
  }
  @container (max-width: 620px) {
    :host {
      gap: 0.75rem;
    }
    .name {
      display: none;
    }
    select {
      flex: 1;
      width: 0;
    }
    button {
      width: 2rem;
    }
  }
`;

/**
 * With more polygons than this, the options exist only while the list is open: browsers examine all options at each layout
 * of the page.
 */
const crowd = 100;

const shapes = {
  over: 'M3 13a6.5 6.5 0 0 1 13 -1M16 6.500v5.500h-5.500M9.500 16h.01',
  out: 'M10 16v-12M5.500 8.500l4.500 -4.500 4.500 4.500M14.500 16h3',
  next: 'M4 10h12M11 5l5 5 -5 5',
} as const;

/** Moves through a run that are longer than a step: over and out of procedures, and to the next goal. */
@customElement('vidno-travel')
export class TravelElement extends LitElement {
  static override styles = [base, travelStyle];

  @property({ attribute: false }) trace!: Trace;
  @property({ attribute: false }) view!: View;
  @property({ attribute: false }) check!: Check;
  @property({ attribute: false }) history: Followed | null = null;
  @property({ attribute: false }) bookmarks: Bookmarks = [];
  /** Only the buttons for the next goal and out of the procedure; the keys do everything. */
  @property({ type: Boolean, reflect: true }) brief = false;
  @state() private chosen: Goal | null = null;
  /** Whether the list of polygons is about to open. */
  @state() private isOpen = false;
  private calls: Calls | null = null;
  private goals: Goals | null = null;

  override willUpdate(changed: PropertyValues<this>): void {
    if (!changed.has('trace')) return;
    this.calls = null;
    this.goals = null;
    this.chosen = null;
    this.isOpen = false;
  }

  private get texts(): TravelTexts {
    return texts[this.view.language].travel;
  }

  private get goal(): Goal {
    const [first = 'wrong'] = goalsOf(this.view.header.method);
    return this.chosen ?? first;
  }

  private stepsOf(goal: Goal): readonly number[] {
    if (goal === 'wrong' && this.check.is === 'found') return this.check.truth.wrong;
    this.goals ??= new Goals(this.trace);
    return this.goals.stepsOf(goal, this.history, this.bookmarks);
  }

  /** Steps over a procedure, or out of the current one. */
  call(way: 'over' | 'out', direction: Direction): void {
    if (this.calls?.length !== this.view.length) this.calls = new Calls(this.trace);
    this.goTo(this.calls[way](this.view.step, direction));
  }

  /** Goes to the nearest goal, of the chosen kind by default. */
  next(direction: Direction, goal = this.goal): void {
    const { back, forward } = around(this.stepsOf(goal), this.view.step);
    const step = direction === 1 ? forward : back;
    if (step !== null) this.goTo(step);
  }

  private goTo(step: number): void {
    this.dispatchEvent(new CustomEvent<Command>('command', { detail: { do: 'seek', step } }));
  }

  override render(): TemplateResult {
    const { view } = this;
    const steps = this.stepsOf(this.goal);
    const { back, forward } = around(steps, view.step);
    const say = this.texts;
    return html`
      ${this.brief ? this.out() : this.procedures()}
      <div class="group goal" role="group" aria-label=${say.goTo}>
        <span class="name" aria-hidden="true">${say.goTo}</span>
        ${
          this.brief
            ? nothing
            : this.button('next', -1, [say.previous, ','], back === null, () => this.next(-1))
        }
        <select
          aria-label=${say.goTo}
          @pointerdown=${this.onOpen}
          @focus=${this.onOpen}
          @blur=${this.onClose}
          @change=${this.onChoose}
        >
          ${this.options()}
        </select>
        ${this.button('next', 1, [say.next, '.'], forward === null, () => this.next(1))}
        <span class="count" role="status">${this.counted(steps)}</span>
      </div>
    `;
  }

  private out(): TemplateResult {
    const { step, length } = this.view;
    const say = this.texts;
    return this.button('out', 1, [say.out, 'Shift ]'], step === length, () => this.call('out', 1));
  }

  /** The buttons to step over and out of a procedure. */
  private procedures(): TemplateResult {
    const { step, length } = this.view;
    const say = this.texts;
    return html`<div class="group" role="group" aria-label=${say.procedure}>
      <span class="name" aria-hidden="true">${say.procedure}</span>
      ${this.button('out', -1, [say.outBack, 'Shift ['], step === 0, () => this.call('out', -1))}
      ${this.button('over', -1, [say.overBack, '['], step === 0, () => this.call('over', -1))}
      ${this.button('over', 1, [say.over, ']'], step === length, () => this.call('over', 1))}
      ${this.out()}
    </div>`;
  }

  /** The position of the step among the goals. */
  private counted(steps: readonly number[]): string {
    const at = steps.indexOf(this.view.step);
    if (steps.length === 0) return this.none();
    return at < 0 ? String(steps.length) : `${at + 1} / ${steps.length}`;
  }

  /** The text without goals. In an unchecked run the wrong decisions are unknown. */
  private none(): string {
    const { exact } = texts[this.view.language];
    const { is } = this.check;
    if (this.goal !== 'wrong' || is === 'checked' || is === 'certain' || is === 'found') {
      return this.texts.noGoal;
    }
    return is === 'checking' ? exact.checkingShort : exact.notChecked;
  }

  private options(): unknown {
    const { header, language } = this.view;
    return guard([header, language, this.chosen, this.isOpen], () => {
      const { goal } = this;
      const polygon = typeof goal === 'object' ? goal.polygon : null;
      const { polygons } = header.scene;
      const isWhole = this.isOpen || polygons.length <= crowd;
      const offered = isWhole ? polygons : polygons.filter(({ id }) => id === polygon);
      return html`
        ${goalsOf(header.method).map(
          (name) =>
            html`<option value=${name} ?selected=${name === goal}>
              ${this.texts.goals[name]}
            </option>`,
        )}
        <optgroup label=${this.texts.ofPolygon}>
          ${offered.map(
            ({ id }) =>
              html`<option value="polygon ${id}" ?selected=${id === polygon}>${id}</option>`,
          )}
        </optgroup>
      `;
    });
  }

  private onOpen(): void {
    this.isOpen = true;
  }

  private onClose(): void {
    this.isOpen = false;
  }

  private onChoose(event: Event): void {
    const { value } = event.target as HTMLSelectElement;
    const id = value.startsWith('polygon ') ? value.slice('polygon '.length) : null;
    this.chosen = id === null ? (value as GoalName) : { polygon: id };
    if (this.chosen === 'wrong') askCheck(this);
  }

  private button(
    shape: keyof typeof shapes,
    direction: Direction,
    [label, key]: readonly [string, string],
    off: boolean,
    act: () => void,
  ): TemplateResult {
    return html`<button
      class=${direction === -1 ? 'back' : nothing}
      aria-label=${label}
      title=${withKey(label, key)}
      aria-disabled=${off ? 'true' : 'false'}
      @click=${act}
    >
      <svg viewBox="0 0 20 20" aria-hidden="true">${svg`<path d=${shapes[shape]} />`}</svg>
    </button>`;
  }
}
