import { LitElement, html, nothing, svg } from 'lit';
import type { PropertyValues, TemplateResult } from 'lit';
import { customElement, property, query, state } from 'lit/decorators.js';
import { live } from 'lit/directives/live.js';
import type { View } from '../algorithm/view.js';
import { rest } from '../base/rest.js';
import { hiddenStyle } from '../elements/hidden.style.js';
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
import { isIn } from '../time/range.js';
import { flag, lanesOf, stripHeight } from './lanes.js';
import './hits.js';
import './overview.js';
import { sliderStyle } from './slider.style.js';
import './strip-element.js';
import { StripGestures } from './strip-gestures.js';
import './strip-legend.js';
import { Zoom } from './zoom.js';
import { zoomByKey } from './zoom-keys.js';

const mostPerFrame = 8;

/**
 * The slider and the strip along it, which shows the run or a part of it. Both seek. The reader chooses the part on the
 * overview between them, or on the strip itself.
 */
@customElement('vidno-slider')
export class SliderElement extends LitElement {
  static override styles = [base, hiddenStyle, sliderStyle];

  @property({ attribute: false }) trace!: Trace;
  @property({ attribute: false }) view!: View;
  /** Which decisions are known to be wrong, if the trace does not say so. */
  @property({ attribute: false }) check!: Check;
  @property({ attribute: false }) bookmarks: Bookmarks = [];
  /** The steps that a search has found, in order. */
  @property({ attribute: false }) hits: readonly number[] = [];
  /** The reachable steps. */
  @property({ attribute: false }) first = 0;
  @property({ attribute: false }) last = 0;
  /** Without the strip. */
  @property({ type: Boolean }) plain = false;
  /** Whether everything after the step is hidden, and the extent of the current item. */
  @property({ type: Boolean }) veiled = false;
  /** The step under the mouse. */
  @state() private pointed: number | null = null;
  /** The announcement about the part that the strip shows, since its last change. */
  @state() private news = '';
  @query('.strip') private strip!: HTMLElement;

  @state() private rested = false;

  private course!: Course;
  private timer = 0;
  private readonly reader = new ReadOn(this, mostPerFrame);
  private readonly zoom = new Zoom();
  private readonly gestures = new StripGestures(this.zoom, () => this.onZoom());

  override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has('trace')) {
      this.pointed = null;
      this.news = '';
      this.wait();
    }
    const { header, length, step } = this.view;
    this.zoom.follow(header, length, step);
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

  /** The strip with its legend. */
  private whole(): TemplateResult {
    const { view, zoom } = this;
    const { step, length, language } = view;
    const { range } = zoom;
    const { zoom: say } = texts[language].strip;
    const course = this.trace.complete && this.course.complete ? this.course : null;
    const isShown = ({ step: at }: { readonly step: number }): boolean => isIn(range, at);
    return html`
      <vidno-strip-legend
        .header=${view.header}
        .language=${language}
        ?unchecked=${this.check.is !== 'told' && this.check.is !== 'certain' && this.check.is !== 'found'}
      ></vidno-strip-legend>
      <vidno-overview
        .zoom=${zoom}
        .range=${range}
        .length=${length}
        .step=${step}
        .course=${course}
        .texts=${say}
        @change=${this.onZoom}
      ></vidno-overview>
      ${this.wayBack()}
      <div
        class="strip"
        role="slider"
        tabindex="0"
        aria-label=${say.part}
        aria-valuemin=${range.from}
        aria-valuemax=${range.to}
        aria-valuenow=${step}
        aria-valuetext=${`${say.shown(range, length)}; ${this.say(step)}`}
        @keydown=${this.onZoomKey}
        @wheel=${this.gestures.onWheel}
        @pointerdown=${this.onPress}
        @pointermove=${this.onPoint}
        @pointerup=${this.gestures.onEnd}
        @pointercancel=${this.gestures.onEnd}
        @pointerleave=${this.forget}
      >
        <vidno-strip .course=${course} .range=${range}></vidno-strip>
        <vidno-hits .hits=${this.hits} .range=${range}></vidno-hits>
        ${this.bookmarks
          .filter(isShown)
          .map(
            (bookmark) =>
              html`<svg class="flag" .style=${this.at(bookmark.step)} aria-hidden="true">
                ${svg`<path d=${flag(stripHeight)} />`}
              </svg>`,
          )}
        ${
          this.veiled
            ? nothing
            : findingSteps(this.check.findings ?? [], view.length)
                .filter(isShown)
                .map(
                  (found) =>
                    html`<span
                      class="found ${found.kind}"
                      .style=${this.at(found.step)}
                      aria-hidden="true"
                    ></span>`,
                )
        }
        ${this.veiled ? html`<span class="veil" .style=${this.at(step)}></span>` : nothing}
        ${isShown(view) ? html`<span class="now" .style=${this.at(step)}></span>` : nothing}
      </div>
      <div class="lanes" aria-hidden="true">
        ${lanesOf(view.header).map(
          ({ name, top, height }) =>
            html`<span .style=${`top: ${top}px; height: ${height}px`}
              >${texts[language].strip.lanes[name]}</span
            >`,
        )}
      </div>
      <span class="heard" role="status">${this.news}</span>
      ${this.tip()}
    `;
  }

  /** The button that returns from a part to the whole run. */
  private wayBack(): TemplateResult | typeof nothing {
    if (this.zoom.isWhole) return nothing;
    const label = texts[this.view.language].strip.zoom.toWhole;
    return html`<button class="whole" aria-label=${label} title=${label} @click=${this.onWhole}>
      <svg viewBox="0 0 20 20" aria-hidden="true">
        ${svg`<path d="M3 6v8M17 6v8M5 10h10M8 7l-3 3 3 3M12 7l3 3-3 3" />`}
      </svg>
    </button>`;
  }

  /** The button disappears. If it was pressed by keyboard, the focus stays near it. */
  private readonly onWhole = ({ detail }: MouseEvent): void => {
    this.zoom.showWhole();
    if (detail === 0) this.strip.focus();
    this.onZoom();
  };

  private readonly onZoomKey = (event: KeyboardEvent): void => {
    if (!zoomByKey(event, this.zoom)) return;
    event.preventDefault();
    this.onZoom();
  };

  /** A focused strip announces its new range itself. */
  private readonly onZoom = (): void => {
    const { language, length } = this.view;
    const isFocused = this.shadowRoot?.activeElement === this.strip;
    this.news = isFocused ? '' : texts[language].strip.zoom.shown(this.zoom.range, length);
    this.requestUpdate();
  };

  private tip(): TemplateResult | typeof nothing {
    if (this.pointed === null || this.veiled) return nothing;
    const place = this.at(this.pointed);
    return html`<p class="tip" .style=${place} aria-hidden="true">${this.say(this.pointed)}</p>`;
  }

  private at(step: number): string {
    return `--at: ${Math.min(Math.max(0, placeOf(step, this.zoom.range, 1)), 1)}`;
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
    const bookmarked = this.bookmarks.map(({ step }) => step);
    const marked = [bookmarked, course.faults, course.wrong, this.hits];
    return aimedAt(clientX - left, this.zoom.range, width, marked);
  }

  private onPress(event: PointerEvent): void {
    if (event.button !== 0) return;
    this.strip.setPointerCapture(event.pointerId);
    this.gestures.onDown(event);
    if (!this.gestures.isPinch) this.seek(this.aimed(event));
  }

  private onPoint(event: PointerEvent): void {
    this.gestures.onMove(event);
    this.pointed = this.aimed(event);
    addEventListener('keydown', this.onKey);
    const seeks = this.strip.hasPointerCapture(event.pointerId) && !this.gestures.isPinch;
    if (seeks) this.seek(this.pointed);
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
