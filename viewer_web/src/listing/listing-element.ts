import { LitElement, html, nothing } from 'lit';
import type { PropertyValues, TemplateResult } from 'lit';
import { customElement, property, state } from 'lit/decorators.js';
import { numbersOf } from '../algorithm/view.js';
import type { View } from '../algorithm/view.js';
import { base } from '../elements/theme.js';
import { Follower } from '../picture/in-sight.js';
import type { Trace } from '../replay/trace.js';
import './cpp.js';
import { valuesInPlay } from './in-play.js';
import { listingStyle } from './listing.style.js';
import { listingsOf } from './listings.js';
import type { Line, Listing } from './listings.js';

/** The procedures, the current line and the lines that wait for a result. */
@customElement('vidno-listing')
export class ListingElement extends LitElement {
  static override styles = [base, listingStyle];

  @property({ attribute: false }) trace!: Trace;
  @property({ attribute: false }) view!: View;

  /** Whether the C++ of the same procedures is shown instead. */
  @state() private source = false;

  private listings: readonly Listing[] = [];
  private shown = '';
  private values: ReadonlyMap<string, string> = new Map();

  override willUpdate(): void {
    const { header, language } = this.view;
    const shown = [header.method, header.edition, header.detail, language].join();
    if (shown === this.shown) return;
    this.shown = shown;
    this.listings = listingsOf(header, language);
  }

  override render(): TemplateResult {
    const { texts, after } = this.view;
    return html`
      <div class="head">
        <ol class="calls" aria-label=${texts.callStack}>
          ${after.calls.map(({ of, at }) => html`<li>${of} <b>${at ?? ''}</b></li>`)}
        </ol>
        <button
          aria-pressed=${this.source ? 'true' : 'false'}
          title=${texts.source}
          @click=${() => this.toggleSource()}
        >
          C++
        </button>
      </div>
      ${this.source ? html`<vidno-cpp .view=${this.view}></vidno-cpp>` : this.procedures()}
    `;
  }

  toggleSource(): void {
    this.source = !this.source;
  }

  private procedures(): TemplateResult {
    this.values = valuesInPlay(this.trace, this.view.step, numbersOf(this.view));
    return html`<div
      class="procedures"
      tabindex="0"
      role="region"
      aria-label=${this.view.texts.listing}
    >
      ${this.listings.map((listing) => this.procedure(listing))}
    </div>`;
  }

  private readonly follower = new Follower();

  private get current(): string | null {
    return this.view.event?.at ?? null;
  }

  private isCaller(at: string): boolean {
    return this.view.after.calls.slice(0, -1).some((frame) => frame.at === at);
  }

  /** A procedure that was just called is at no line yet: its name is marked. */
  private isEntered(name: string): boolean {
    const top = this.view.after.calls.at(-1);
    return this.view.event?.e === 'call' && top?.of === name;
  }

  private procedure({ name, title, takes, lines }: Listing): TemplateResult {
    return html`
      <section class=${this.isEntered(name) ? 'entered' : nothing}>
        <h3><span class="name">${name}</span>(${takes}) <span class="title">${title}</span></h3>
        <ol>
          ${lines.map((line) => this.line(line))}
        </ol>
      </section>
    `;
  }

  private line({ at, indent, text, defects, speaks }: Line): TemplateResult {
    const now = at === this.current;
    const kind = now && !this.isCaller(at) ? 'now' : this.isCaller(at) ? 'caller' : '';
    return html`
      <li class=${kind} aria-current=${now ? 'step' : nothing}>
        <span class="at">${at}</span>
        <code .style=${`--indent: ${indent}`}>${text}${speaks ? this.said(at) : nothing}</code>
        ${defects.map((id) => this.defect(id))}
      </li>
    `;
  }

  /** What the line last said; its place is kept where it says nothing now, so that no line moves. */
  private said(at: string): TemplateResult {
    const said = this.values.get(at) ?? '';
    return html`<var title=${said}>${said}</var>`;
  }

  private defect(id: string): TemplateResult {
    return html`<abbr class="defect" title=${this.view.texts.defect(id)}>${id}</abbr>`;
  }

  override updated(changed: PropertyValues<this>): void {
    super.updated(changed);
    const find = (what: string): HTMLElement | null => this.renderRoot.querySelector(what);
    // Before the first step one looks at the beginning.
    const mark = this.view.step === 0 ? find('section') : (find('.entered h3') ?? find('.now'));
    this.follower.follow(find('.procedures'), mark);
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'vidno-listing': ListingElement;
  }
}
