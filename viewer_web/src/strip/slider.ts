import { LitElement, html, nothing, svg } from 'lit';
import type { PropertyValues, TemplateResult } from 'lit';
import { customElement, property, query, state } from 'lit/decorators.js';
import { live } from 'lit/directives/live.js';
import type { View } from '../algorithm/view.js';
import { ReadOn } from '../elements/read-on.js';
import { base } from '../elements/theme.js';
import { findingSteps } from '../exactness/finding-marks.js';
import type { Check } from '../exactness/truth.js';
import { texts } from '../i18n/index.js';
import type { Trace } from '../replay/trace.js';
import type { Bookmarks } from '../time/bookmarks.js';
import { aimedAt, placeOf } from '../time/columns.js';
import type { Command } from '../time/command.js';
import { Course } from '../time/course.js';
import { sayPlace } from '../time/place.js';
import { flag, lanesOf, stripHeight } from './lanes.js';
import { sliderStyle } from './slider.style.js';
import './strip-element.js';
import './strip-legend.js';

const mostPerFrame = 8;
/** Milliseconds that a run must stay: while a scene is dragged none does. */
const rest = 150;

/** The slider, and along it the strip that shows the whole run. Both seek; the keyboard has the slider. */
@customElement('vidno-slider')
export class SliderElement extends LitElement {
  static override styles = [base, sliderStyle];

  @property({ attribute: false }) trace!: Trace;
  @property({ attribute: false }) view!: View;
  /** Where decisions are known to be wrong, if the trace does not say so. */
  @property({ attribute: false }) check!: Check;
  @property({ attribute: false }) bookmarks: Bookmarks = [];
  /** The steps that can be reached. */
  @property({ attribute: false }) first = 0;
  @property({ attribute: false }) last = 0;
  /** Without the strip. */
  @property({ type: Boolean }) plain = false;
  /** What comes after the step is hidden, and what the step is in the midst of. */
  @property({ type: Boolean }) veiled = false;
  /** The step that the mouse points at. */
  @state() private pointed: number | null = null;
  @query('.strip') private strip!: HTMLElement;

  @state() private rested = false;

  private course!: Course;
  private timer = 0;
  private readonly reader = new ReadOn(this, mostPerFrame);

  override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has('trace')) {
      this.pointed = null;
      this.wait();
    }
    if (changed.has('trace') || changed.has('check')) this.course = this.fresh();
    if (this.rested) this.reader.read(this.course);
  }

  private fresh(): Course {
    return new Course(this.trace, this.check.is === 'found' ? this.check.truth.wrong : []);
  }

  private wait(): void {
    clearTimeout(this.timer);
    this.rested = false;
    this.timer = window.setTimeout(() => (this.rested = true), rest);
  }

  override render(): TemplateResult {
    const { view } = this;
    const { step } = view;
    return html`
      <input
        class="slider"
        type="range"
        min=${this.first}
        max=${this.last}
        .value=${live(String(step))}
        aria-label=${view.texts.step}
        aria-valuetext=${this.say(step)}
        @input=${this.onInput}
      />
      ${this.plain ? nothing : this.whole()}
    `;
  }

  /** The strip, with what it means. */
  private whole(): TemplateResult {
    const { view, course } = this;
    const { step, language } = view;
    return html`
      <vidno-strip-legend
        .header=${view.header}
        .language=${language}
        ?unchecked=${this.check.is !== 'told' && this.check.is !== 'certain' && this.check.is !== 'found'}
      ></vidno-strip-legend>
      <div
        class="strip"
        @pointerdown=${this.onPress}
        @pointermove=${this.onPoint}
        @pointerleave=${this.forget}
      >
        <vidno-strip
          .course=${this.trace.complete && course.complete ? course : null}
        ></vidno-strip>
        ${this.bookmarks.map(
          (bookmark) =>
            html`<svg class="flag" .style=${this.at(bookmark.step)} aria-hidden="true">
              ${svg`<path d=${flag(stripHeight)} />`}
            </svg>`,
        )}
        ${
          this.veiled
            ? nothing
            : findingSteps(this.check.findings ?? [], view.length).map(
                (found) =>
                  html`<span
                    class="found ${found.kind}"
                    .style=${this.at(found.step)}
                    aria-hidden="true"
                  ></span>`,
              )
        }
        ${this.veiled ? html`<span class="veil" .style=${this.at(step)}></span>` : nothing}
        <span class="now" .style=${this.at(step)}></span>
      </div>
      <div class="lanes" aria-hidden="true">
        ${lanesOf(view.header).map(
          ({ name, top, height }) =>
            html`<span .style=${`top: ${top}px; height: ${height}px`}
              >${texts[language].strip.lanes[name]}</span
            >`,
        )}
      </div>
      ${this.tip()}
    `;
  }

  private tip(): TemplateResult | typeof nothing {
    if (this.pointed === null || this.veiled) return nothing;
    const place = this.at(this.pointed);
    return html`<p class="tip" .style=${place} aria-hidden="true">${this.say(this.pointed)}</p>`;
  }

  private at(step: number): string {
    return `--at: ${placeOf(step, this.view.length, 1)}`;
  }

  private say(step: number): string {
    const { course, view } = this;
    const say = texts[view.language];
    if (this.veiled) return say.strip.step(step, view.length);
    return sayPlace(course, step, this.bookmarks, say);
  }

  private aimed({ clientX }: PointerEvent): number {
    const { left, width } = this.strip.getBoundingClientRect();
    const { course } = this;
    const marked = [this.bookmarks.map(({ step }) => step), course.faults, course.wrong];
    return aimedAt(clientX - left, this.view.length, width, marked);
  }

  private onPress(event: PointerEvent): void {
    if (event.button !== 0) return;
    this.strip.setPointerCapture(event.pointerId);
    this.seek(this.aimed(event));
  }

  private onPoint(event: PointerEvent): void {
    this.pointed = this.aimed(event);
    addEventListener('keydown', this.onKey);
    if (this.strip.hasPointerCapture(event.pointerId)) this.seek(this.pointed);
  }

  private readonly onKey = ({ key }: KeyboardEvent): void => {
    if (key === 'Escape') this.forget();
  };

  private forget(): void {
    this.pointed = null;
    removeEventListener('keydown', this.onKey);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.forget();
  }

  private onInput(event: Event): void {
    this.seek(Number((event.target as HTMLInputElement).value));
    this.requestUpdate();
  }

  private seek(step: number): void {
    this.dispatchEvent(new CustomEvent<Command>('command', { detail: { do: 'seek', step } }));
  }
}
