import { LitElement, html, nothing } from 'lit';
import type { PropertyValues, TemplateResult } from 'lit';
import { customElement, property, state } from 'lit/decorators.js';
import { classMap } from 'lit/directives/class-map.js';
import { repeat } from 'lit/directives/repeat.js';
import { polygonThing } from '../algorithm/pointed.js';
import { swatch } from '../elements/parts.js';
import { base } from '../elements/theme.js';
import { texts } from '../i18n/index.js';
import type { Language } from '../language/language.js';
import type { Polygon } from '../trace/header.js';
import { depthColumn } from './depth-column.js';
import type { Depth } from './depth-column.js';
import type { History } from './history.js';
import { standingsOf } from './reason.js';
import type { AtPixel, Reason, Standings } from './reason.js';
import { whyStyle } from './why.style.js';

/** Up to this number all polygons are listed at once; of more, those that hold the centre. */
const few = 12;
const page = 40;
/** A longer fraction is rounded until the reader chooses its sentence. */
const longest = 16;

/**
 * Why each polygon shows at the chosen pixel or not, exactly. An event `explain` names the polygon that the reader looks
 * at.
 */
@customElement('vidno-why')
export class WhyElement extends LitElement {
  static override styles = [base, whyStyle];

  @property({ attribute: false }) history!: History;
  @property({ attribute: false }) language!: Language;
  @property({ attribute: false }) pointed: string | null = null;
  /** The places in the scene of the polygons under the pointer, in focus, and pressed. */
  @state() private over: number | null = null;
  @state() private focused: number | null = null;
  @state() private pressed: number | null = null;
  @state() private count = 0;
  @state() private isOpen = true;
  private standings: Standings | null = null;
  private explained: AtPixel | null = null;

  /** A change of the scene makes another history of the pixel: the reader still looks at the same polygon. */
  override willUpdate(changed: PropertyValues<this>): void {
    if (!changed.has('history')) return;
    const { history } = this;
    const { length } = history.trace.header.scene.polygons;
    const holding = history.holding();
    this.standings = holding && standingsOf(holding, length);
    const isSame = changed.get('history')?.pixel.join() === history.pixel.join();
    const first = length <= few ? length : Math.min(holding?.holding.length ?? 0, page);
    this.count = isSame ? Math.max(this.count, first) : first;
    const isThere = (place: number | null): boolean => isSame && place !== null && place < length;
    if (!isThere(this.over)) this.over = null;
    if (!isThere(this.focused)) this.focused = null;
    if (!isThere(this.pressed)) this.pressed = null;
  }

  /** The polygon that the reader looks at. */
  private get chosen(): number | null {
    return this.over ?? this.focused ?? this.pressed;
  }

  override updated(): void {
    const { chosen, standings } = this;
    const detail = chosen === null || standings === null ? null : this.reason(chosen).at;
    if (detail === this.explained) return;
    this.explained = detail;
    this.dispatchEvent(
      new CustomEvent<AtPixel | null>('explain', { detail, bubbles: true, composed: true }),
    );
  }

  private reason(place: number | null): Reason {
    return this.history.reason(place, this.language);
  }

  override render(): TemplateResult | typeof nothing {
    const { standings } = this;
    if (standings === null) return nothing;
    const { owner, holding, others } = standings;
    const { why: say } = texts[this.language];
    const first = owner === null ? holding : [owner, ...holding];
    const listed = [...first, ...others].slice(0, this.count);
    const chosen = this.focused ?? this.pressed;
    const reached = chosen !== null && listed.includes(chosen) ? chosen : listed[0];
    return html`<h3>
        <button
          id="title"
          aria-expanded=${this.isOpen ? 'true' : 'false'}
          aria-controls="reasons"
          @click=${() => (this.isOpen = !this.isOpen)}
        >
          ${say.title}
        </button>
      </h3>
      <div id="reasons" ?hidden=${!this.isOpen}>
        <div>
          ${owner === null ? html`<p>${this.reason(null).said}</p>` : nothing}
          <ul
            aria-labelledby="title"
            @keydown=${this.onKey}
            @pointerleave=${() => (this.over = null)}
            @focusout=${() => (this.focused = null)}
          >
            ${repeat(
              listed,
              (place) => place,
              (place) => this.row(place, place === reached),
            )}
          </ul>
          ${this.more(first.length, first.length + others.length)}
        </div>
        ${this.column(owner, listed)}
      </div>`;
  }

  private row(place: number, isReached: boolean): TemplateResult {
    const { said, at } = this.reason(place);
    const thing = polygonThing(at?.polygon ?? '');
    const isPressed = place === this.pressed;
    const classes = {
      shows: at?.standing === 'shows',
      chosen: place === this.chosen,
      pointed: thing === this.pointed,
    };
    return html`<li class=${classMap(classes)} data-thing=${thing}>
      <button
        tabindex=${isReached ? 0 : -1}
        aria-pressed=${isPressed ? 'true' : 'false'}
        @pointerenter=${() => (this.over = place)}
        @focus=${() => (this.focused = place)}
        @click=${() => this.press(place)}
      >
        ${swatch(this.polygonAt(place).color)}<span
          >${isPressed ? said : this.shortened(said)}</span
        >
      </button>
    </li>`;
  }

  private polygonAt(place: number): Polygon {
    const polygon = this.history.trace.header.scene.polygons[place];
    if (polygon === undefined) throw new Error('a polygon that the scene does not have');
    return polygon;
  }

  private press(place: number): void {
    this.pressed = place === this.pressed ? null : place;
    if (this.pressed === null) this.focused = null;
  }

  /** The sentence with its long fractions rounded; pointing at one shows it in full. */
  private shortened(said: string): unknown {
    const { short } = texts[this.language].numbers;
    return said
      .split(/(-?\d+\/\d+)/)
      .map((part, i) =>
        i % 2 === 1 && part.length > longest
          ? html`<abbr title=${part}>${short(part)}</abbr>`
          : part,
      );
  }

  private more(holding: number, all: number): TemplateResult | typeof nothing {
    const { count } = this;
    const { why: say } = texts[this.language];
    const end = count < holding ? holding : all;
    if (count >= end) return nothing;
    const label = count === holding ? say.others(end - count) : say.more(end - count);
    return html`<button class="more" @click=${() => (this.count = Math.min(count + page, end))}>
      ${label}
    </button>`;
  }

  /** The depths of the owner and of the chosen polygon, or of the one that would show in its place. */
  private column(owner: number | null, listed: readonly number[]): TemplateResult | typeof nothing {
    if (owner === null) return nothing;
    const { polygons } = this.history.trace.header.scene;
    const next = polygons.findIndex(({ id }) => id === this.reason(owner).at?.next);
    const chosen = this.chosen ?? owner;
    const other = chosen === owner ? next : chosen;
    const own = this.depth(owner);
    const others = other < 0 ? null : this.depth(other);
    const { numbers, why: say } = texts[this.language];
    if (own === null || others === null) return html`<div class="column"></div>`;
    const all = listed.flatMap((place) => {
      const { at } = this.reason(place);
      return at?.standing === 'behind' && at.depth !== undefined ? [at.depth] : [];
    });
    const { gap } = this.reason(other).at ?? {};
    return depthColumn({ owner: own, other: others, gap, all }, say, numbers);
  }

  private depth(place: number): Depth | null {
    const { at } = this.reason(place);
    if (at?.depth === undefined) return null;
    const { id, color } = this.polygonAt(place);
    return { id, color, depth: at.depth, holds: at.standing !== 'beside' };
  }

  /** Tab reaches only one sentence; the arrow keys move between them. */
  private onKey(event: KeyboardEvent): void {
    const by = { ArrowUp: -1, ArrowDown: 1 }[event.key];
    if (by === undefined) return;
    const all = [...this.renderRoot.querySelectorAll<HTMLElement>('li button')];
    const at = all.findIndex((button) => button.matches(':focus'));
    all[at + by]?.focus();
    event.preventDefault();
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'vidno-why': WhyElement;
  }
}
