import { LitElement, css, html, nothing, svg } from 'lit';
import type { PropertyValues, TemplateResult } from 'lit';
import { customElement, property, query, state } from 'lit/decorators.js';
import { live } from 'lit/directives/live.js';
import type { View } from '../algorithm/view.js';
import { ReadOn, rest } from '../elements/read-on.js';
import { base, hiddenStyle } from '../elements/theme.js';
import { findingSteps } from '../exactness/finding-marks.js';
import type { Check } from '../exactness/truth.js';
import { texts } from '../i18n/index.js';
import type { Trace } from '../replay/trace.js';
import type { Bookmarks } from '../time/bookmarks.js';
import { aimedAt, placeOf } from '../time/columns.js';
import type { Command } from '../time/travel.js';
import { Course } from '../time/course.js';
import { sayPlace } from '../time/place.js';
import { isIn } from '../time/range.js';
import { flag, lanesOf, stripHeight } from './lanes.js';
import './hits.js';
import './overview.js';
import './strip-element.js';
import { StripGestures } from './strip-gestures.js';
import './strip-legend.js';
import { Zoom, zoomByKey } from './zoom.js';

/** The thumb's centre is at the place of the step on the strip: half a thumb from both ends. */
const sliderStyle = css`
  :host {
    --thumb: 1rem;
    position: relative;
    display: grid;
    grid-template-columns: minmax(0, 1fr) auto;
    gap: 0 0.5rem;
    align-items: center;
  }
  .slider {
    appearance: none;
    width: 100%;
    height: 1.5rem;
    margin: 0;
    border-radius: 4px;
    background: none;
    contain: strict;
    cursor: pointer;
  }
  .slider::-webkit-slider-runnable-track {
    height: 0.3rem;
    border-radius: 0.15rem;
    background: color-mix(in srgb, var(--soft) 45%, var(--panel));
  }
  .slider::-moz-range-track {
    height: 0.3rem;
    border-radius: 0.15rem;
    background: color-mix(in srgb, var(--soft) 45%, var(--panel));
  }
  .slider::-webkit-slider-thumb {
    appearance: none;
    width: var(--thumb);
    height: var(--thumb);
    margin-top: -0.35rem;
    border: 0;
    border-radius: 50%;
    background: var(--accent);
  }
  .slider::-moz-range-thumb {
    width: var(--thumb);
    height: var(--thumb);
    border: 0;
    border-radius: 50%;
    background: var(--accent);
  }
  vidno-overview,
  .strip {
    margin: 0 calc(var(--thumb) / 2);
  }
  vidno-overview {
    grid-row: 2;
    grid-column: 1;
    display: var(--strip, block);
  }
  .strip,
  .lanes {
    grid-row: 3;
  }
  .strip {
    grid-column: 1;
    position: relative;
    display: var(--strip, block);
    height: ${stripHeight}px;
    contain: layout size;
    cursor: pointer;
    touch-action: pan-y;
    user-select: none;
  }
  .strip vidno-strip {
    height: 100%;
  }
  .strip:focus-visible {
    outline-offset: 2px;
  }
  .now,
  .flag {
    position: absolute;
    top: 0;
    left: calc(var(--at) * 100%);
    height: 100%;
    pointer-events: none;
  }
  .veil {
    position: absolute;
    inset: 0 0 0 calc(var(--at) * 100%);
    background: repeating-linear-gradient(135deg, var(--well) 0 6px, var(--line) 6px 7px);
  }
  .now {
    width: 2px;
    margin-left: -1px;
    background: var(--ink);
    box-shadow: 0 0 0 1px var(--panel);
  }
  .flag {
    width: 9px;
    margin-left: -1px;
    fill: var(--accent);
    stroke: var(--panel);
    stroke-width: 1;
    paint-order: stroke;
    overflow: visible;
  }
  .tip {
    position: absolute;
    bottom: ${stripHeight + 2}px;
    left: calc(var(--at) * 100%);
    z-index: 2;
    width: max-content;
    max-width: 100%;
    padding: 0.25rem 0.55rem;
    border: 1px solid var(--line);
    border-radius: 6px;
    background: var(--panel);
    box-shadow: 0 2px 10px rgb(10 12 18 / 25%);
    font-size: 0.8125rem;
    line-height: 1.25;
    overflow-wrap: anywhere;
    transform: translateX(calc(var(--at) * -100%));
    pointer-events: none;
  }
  .whole {
    position: absolute;
    top: 0;
    right: 0;
    z-index: 1;
    display: grid;
    place-items: center;
    width: 1.75rem;
    min-height: 1.5rem;
    height: 1.5rem;
    padding: 0;
    color: var(--soft);
  }
  .whole svg {
    width: 1.1rem;
    height: 1.1rem;
    fill: none;
    stroke: currentColor;
    stroke-width: 1.6;
    stroke-linecap: round;
    stroke-linejoin: round;
  }
  .lanes {
    grid-column: 2;
    position: relative;
    align-self: stretch;
    width: 4.1rem;
    color: var(--soft);
    font-size: 0.6875rem;
    line-height: 1;
  }
  .lanes span {
    position: absolute;
    display: flex;
    align-items: center;
    white-space: nowrap;
  }
  /* The system's colours would hide the track and the thumb. */
  @media (forced-colors: active) {
    .slider {
      forced-color-adjust: none;
    }
    .slider::-webkit-slider-runnable-track {
      background: CanvasText;
    }
    .slider::-moz-range-track {
      background: CanvasText;
    }
    .slider::-webkit-slider-thumb {
      background: Highlight;
      box-shadow: 0 0 0 2px Canvas;
    }
    .slider::-moz-range-thumb {
      background: Highlight;
      box-shadow: 0 0 0 2px Canvas;
    }
    .flag {
      fill: CanvasText;
    }
  }
  @container (max-width: 800px) {
    .lanes {
      width: auto;
    }
    .lanes span {
      display: none;
    }
    /* There is no room beside the legend, but beside the strip. */
    .whole {
      top: auto;
      bottom: 0.9rem;
      width: 1.5rem;
      height: 1.5rem;
    }
  }
  .found {
    position: absolute;
    bottom: 0;
    left: calc(var(--at) * 100%);
    width: 2px;
    height: 5px;
    background: #0b7a4b;
    pointer-events: none;
  }
  .found.wrong {
    bottom: 5px;
    height: 8px;
    background: #c1121f;
  }
  .found.narrow {
    bottom: 5px;
    background: #b25e00;
  }
`;

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
        ?unchecked=${this.check.is !== 'checked' && this.check.is !== 'certain' && this.check.is !== 'found'}
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
