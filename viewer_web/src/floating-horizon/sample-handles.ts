import { LitElement, html, nothing, svg } from 'lit';
import type { PropertyValues, SVGTemplateResult, TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { moveSample } from '../run/surface.js';
import type { SampleSpot } from '../run/surface.js';
import { texts } from '../i18n/index.js';
import { led } from '../editor/corner-keys.js';
import type { Place } from '../editor/corner-keys.js';
import type { Sketch } from '../run/sketch.js';
import { overlayStyle } from '../picture/picture.style.js';
import type { Frame } from '../picture/frame.js';
import type { Sample } from '../trace/values.js';
import type { View } from '../algorithm/view.js';
import { act } from '../editor/form.js';
import { Dragging } from '../editor/dragging.js';
import { handlesStyle } from '../editor/handles.style.js';
import { hasPoint } from './shapes.js';
import { base } from '../elements/theme.js';

/** CSS pixels: the radius of handles, and of the area around them that takes the pointer. */
const radius = 5;
const reach = 12;

/** The samples of the current curve over the picture, which can be moved up and down. */
@customElement('vidno-sample-handles')
export class SampleHandlesElement extends LitElement {
  static override styles = [base, overlayStyle, handlesStyle];

  @property({ attribute: false }) view!: View;
  /** The position of the plane in the picture. */
  @property({ attribute: false }) frame!: Frame;

  private readonly dragging = new Dragging(this);
  private keyed: SampleSpot | null = null;

  /** The current curve, or the first one. */
  private get curve(): number {
    return this.view.after.floatingHorizon?.curve ?? 0;
  }

  private sampleAt({ curve, sample }: SampleSpot): Sample | undefined {
    const found = this.view.header.scene.curves?.[curve]?.[sample];
    return found !== undefined && hasPoint(found) ? found : undefined;
  }

  override updated(changed: PropertyValues<this>): void {
    super.updated(changed);
    const moved = this.keyed === null ? undefined : this.sampleAt(this.keyed);
    if (moved !== undefined) this.follow(moved);
    this.keyed = null;
  }

  override render(): TemplateResult {
    const { frame, view, curve } = this;
    const samples = view.header.scene.curves?.[curve] ?? [];
    const [[first = 0] = [], [last = 0] = []] = [samples[0], samples.at(-1)];
    const apart = ((last - first) * frame.scale) / Math.max(1, samples.length - 1);
    const r = Math.min(radius, Math.max(1.5, 0.4 * apart));
    return html`<svg viewBox=${frame.shown.join(' ')}>
      ${samples.map((at, sample) => (hasPoint(at) ? this.handle(at, { curve, sample }, r) : nothing))}
    </svg>`;
  }

  private handle([x, y]: Sample, spot: SampleSpot, r: number): SVGTemplateResult {
    const { scale } = this.frame;
    const { surface } = texts[this.view.language].curves;
    return svg`<g
      class="handle"
      tabindex="0"
      role="button"
      aria-label=${surface.sample(spot.curve, x, y)}
      data-spot="${spot.curve},${spot.sample}"
      @pointerdown=${(event: PointerEvent) => this.drag(event, spot)}
      @keydown=${(event: KeyboardEvent) => this.onKey(event, spot)}
      @focus=${() => this.follow([x, y])}
    >
      <circle class="reach" cx=${x} cy=${y} r=${reach / scale} />
      <circle class="knob" cx=${x} cy=${y} r=${r / scale} />
    </g>`;
  }

  private moved(old: Sketch, spot: SampleSpot, to: (at: Sample) => number): Sketch {
    return moveSample(old, this.view.header.scene.curves ?? [], spot, to);
  }

  private drag(event: PointerEvent, spot: SampleSpot): void {
    const sample = this.sampleAt(spot);
    if (sample === undefined) return;
    this.dragging.start(event, sample, ([, y], old) => this.moved(old, spot, () => y));
  }

  private onKey(event: KeyboardEvent, spot: SampleSpot): void {
    if (event.ctrlKey || event.metaKey || this.sampleAt(spot) === undefined) return;
    const isUpOrDown = event.key === 'ArrowUp' || event.key === 'ArrowDown';
    if (!isUpOrDown) return;
    event.preventDefault();
    // Starts from where earlier keys, possibly not yet shown, have moved the sample.
    const to = (at: Sample): number => (led(at, event) ?? at)[1];
    const edit = (old: Sketch): Sketch => this.moved(old, spot, to);
    act(this, { do: 'edit', edit, name: `${event.key} ${spot.curve} ${spot.sample}` });
    this.keyed = spot;
  }

  /** Scrolls the focused sample into the picture. */
  private follow([x, y]: Place): void {
    this.dispatchEvent(new CustomEvent<Place>('follow', { detail: [x, y] }));
  }
}
