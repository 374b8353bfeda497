import { LitElement, html, nothing } from 'lit';
import type { PropertyValues, TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { listingsOf } from '../listing/listings.js';
import type { Line, Listing } from '../listing/listings.js';
import type { View } from '../view.js';
import { listingStyle } from './listing.style.js';
import { base } from './theme.js';

/** The procedures, the current line and the lines that wait for a result. */
@customElement('vidno-listing')
export class ListingElement extends LitElement {
  static override styles = [base, listingStyle];

  @property({ attribute: false }) view!: View;

  override render(): TemplateResult {
    const { header, language, texts } = this.view;
    const listings = listingsOf(header.method, header.edition, language);
    return html`
      <ol class="calls" aria-label=${texts.callStack}>
        ${this.view.after.calls.map(({ of, at }) => html`<li>${of} <b>${at ?? ''}</b></li>`)}
      </ol>
      <div class="procedures" tabindex="0" role="region" aria-label=${texts.listing}>
        ${listings.map((listing) => this.procedure(listing))}
      </div>
    `;
  }

  private followed: Element | null = null;

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

  private line({ at, indent, text, defects }: Line): TemplateResult {
    const now = at === this.current;
    const kind = now && !this.isCaller(at) ? 'now' : this.isCaller(at) ? 'caller' : '';
    return html`
      <li class=${kind} aria-current=${now ? 'step' : nothing}>
        <span class="at">${at}</span>
        <code .style=${`--indent: ${indent}`}>${text}</code>
        ${defects.map((id) => this.defect(id))}
      </li>
    `;
  }

  private defect(id: string): TemplateResult {
    return html`<abbr class="defect" title=${this.view.texts.defect(id)}>${id}</abbr>`;
  }

  override updated(changed: PropertyValues<this>): void {
    super.updated(changed);
    this.follow();
  }

  /**
   * Scrolls within the listing only, and only when the line is another and out of sight: to look where it is makes the
   * browser lay out the page.
   */
  private follow(): void {
    const box = this.renderRoot.querySelector('.procedures');
    const mark =
      this.renderRoot.querySelector('.entered h3') ?? this.renderRoot.querySelector('.now');
    if (mark === this.followed) return;
    this.followed = mark;
    if (!(box instanceof HTMLElement) || !(mark instanceof HTMLElement)) return;
    const { offsetTop: top, offsetHeight: height } = mark;
    const hidden = top < box.scrollTop || top + 2 * height > box.scrollTop + box.clientHeight;
    if (hidden) box.scrollTop = top - box.clientHeight / 3;
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'vidno-listing': ListingElement;
  }
}
