import { LitElement, css, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property, state } from 'lit/decorators.js';
import { base } from '../elements/theme.js';
import type { ZoomTexts } from '../language/texts.js';
import { placeOf, stepAt } from '../time/columns.js';
import type { Course } from '../time/course.js';
import { between, isWhole, moved, wholeOf } from '../time/range.js';
import type { Range } from '../time/range.js';
import './strip-element.js';
import { shareOf } from './strip-gestures.js';
import type { Zoom } from './zoom.js';

/** The bar itself takes little room; the area for a finger is larger. */
const overviewStyle = css`
  :host {
    position: relative;
    display: block;
    height: 0.5625rem;
    touch-action: none;
    user-select: none;
    cursor: crosshair;
  }
  vidno-strip {
    height: 0.4375rem;
    border-radius: 2px;
    overflow: hidden;
  }
  .bar {
    position: absolute;
    inset: 0;
    border-radius: 3px;
  }
  .part,
  .drawn {
    position: absolute;
    top: -2px;
    bottom: 2px;
    left: calc(var(--from) * 100%);
    min-width: 4px;
    width: calc((var(--to) - var(--from)) * 100%);
    border: 1px solid var(--ink);
    border-block-width: 2px;
    border-radius: 3px;
    box-shadow: 0 0 0 1px var(--panel);
    pointer-events: none;
  }
  .part::before,
  .part::after {
    content: '';
    position: absolute;
    top: -2px;
    bottom: -2px;
    width: 4px;
    background: var(--ink);
  }
  .part::before {
    left: -3px;
    border-radius: 3px 0 0 3px;
  }
  .part::after {
    right: -3px;
    border-radius: 0 3px 3px 0;
  }
  .drawn {
    border-color: var(--accent);
    background: color-mix(in srgb, var(--accent) 30%, transparent);
  }
  .outside {
    position: absolute;
    top: 0;
    height: 0.4375rem;
    background: color-mix(in srgb, var(--panel) 62%, transparent);
    pointer-events: none;
  }
  .before {
    left: 0;
    width: calc(var(--from) * 100%);
  }
  .after {
    right: 0;
    left: calc(var(--to) * 100%);
  }
  .now {
    position: absolute;
    top: 0;
    left: calc(var(--at) * 100%);
    width: 2px;
    height: 0.4375rem;
    margin-left: -1px;
    background: var(--ink);
    pointer-events: none;
  }
`;

/** CSS pixels: the distance from an end of the part at which a pointer grabs it. */
const reach = 8;
/** CSS pixels that a press may move without a choice. */
const still = 3;

/** The action of the pointer: draws another part, or moves the current one, or one of its ends. */
interface Drag {
  readonly what: 'draw' | 'move' | 'from' | 'to';
  readonly pressed: number;
  readonly range: Range;
  /** Whether it has moved farther than a press. */
  moves: boolean;
}

/**
 * A small picture of the whole run with the part that the strip shows. The part can be drawn, moved, or resized at an end.
 * An event `change` reports that it has changed. The keyboard controls are on the strip.
 */
@customElement('vidno-overview')
export class OverviewElement extends LitElement {
  static override styles = [base, overviewStyle];

  @property({ attribute: false }) zoom!: Zoom;
  /** The visible range of the zoom. */
  @property({ attribute: false }) range!: Range;
  @property({ attribute: false }) length = 0;
  @property({ attribute: false }) step = 0;
  /** The course of the whole run; null until it was analysed. */
  @property({ attribute: false }) course: Course | null = null;
  @property({ attribute: false }) texts!: ZoomTexts;
  /** The part that is being drawn. */
  @state() private drawn: Range | null = null;
  private drag: Drag | null = null;

  override render(): TemplateResult {
    const { range, length, texts, drawn } = this;
    const isAll = isWhole(range, length);
    const place = this.place(range);
    return html`
      <div
        class="bar"
        aria-hidden="true"
        title=${texts.how}
        @pointerdown=${this.onDown}
        @pointermove=${this.onMove}
        @pointerup=${this.onUp}
        @pointercancel=${this.onCancel}
      >
        <vidno-strip .course=${this.course} bare></vidno-strip>
        <span class="now" .style=${`--at: ${placeOf(this.step, wholeOf(length), 1)}`}></span>
        ${
          isAll
            ? nothing
            : html`<span class="outside before" .style=${place}></span
                ><span class="outside after" .style=${place}></span
                ><span class="part" .style=${place}></span>`
        }
        ${drawn === null ? nothing : html`<span class="drawn" .style=${this.place(drawn)}></span>`}
      </div>
    `;
  }

  private place({ from, to }: Range): string {
    const whole = wholeOf(this.length);
    return `--from: ${placeOf(from, whole, 1)}; --to: ${placeOf(to, whole, 1)}`;
  }

  private stepOf(event: PointerEvent): number {
    return stepAt(shareOf(event), wholeOf(this.length), 1);
  }

  private readonly onDown = (event: PointerEvent): void => {
    if (event.button !== 0 || !event.isPrimary) return;
    const bar = event.currentTarget as Element;
    bar.setPointerCapture(event.pointerId);
    const { range, length } = this;
    this.drag = { what: this.heldBy(event), pressed: event.clientX, range, moves: false };
    if (this.drag.what === 'draw')
      this.drawn = between(this.stepOf(event), this.stepOf(event), length);
  };

  /** What a pointer grabs. */
  private heldBy(event: PointerEvent): Drag['what'] {
    const { range, length } = this;
    if (isWhole(range, length)) return 'draw';
    const { width } = (event.currentTarget as Element).getBoundingClientRect();
    const at = shareOf(event) * width;
    const [from, to] = [range.from, range.to].map((step) => placeOf(step, wholeOf(length), width));
    if (from === undefined || to === undefined) return 'draw';
    // If the ends are near each other, each is grabbed from outside, and between them the part is moved.
    if (at >= from - reach && at < Math.min(from + reach, (3 * from + to) / 4)) return 'from';
    if (at <= to + reach && at > Math.max(to - reach, (from + 3 * to) / 4)) return 'to';
    return at > from && at < to ? 'move' : 'draw';
  }

  private readonly onMove = (event: PointerEvent): void => {
    const { drag } = this;
    if (drag === null) return;
    drag.moves ||= Math.abs(event.clientX - drag.pressed) > still;
    if (!drag.moves) return;
    if (drag.what === 'draw') this.drawn = this.dragged(drag, event);
    else this.show(this.dragged(drag, event));
  };

  /** The part during a drag. */
  private dragged({ what, pressed, range }: Drag, event: PointerEvent): Range {
    const { length } = this;
    const { left, width } = (event.currentTarget as Element).getBoundingClientRect();
    const at = this.stepOf(event);
    const start = stepAt(pressed - left, wholeOf(length), width);
    if (what === 'draw') return between(start, at, length);
    if (what === 'from') return between(at, range.to, length);
    if (what === 'to') return between(range.from, at, length);
    return moved(range, at - start, length);
  }

  private readonly onUp = (): void => {
    const { drag, drawn } = this;
    this.onCancel();
    if (drag?.moves === true && drawn !== null) this.show(drawn);
  };

  private readonly onCancel = (): void => {
    this.drag = null;
    this.drawn = null;
  };

  private show(range: Range): void {
    this.zoom.show(range);
    this.tell();
  }

  private tell(): void {
    this.dispatchEvent(new CustomEvent('change'));
  }
}
