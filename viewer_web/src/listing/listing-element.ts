import { LitElement, html, nothing } from 'lit';
import type { PropertyValues, TemplateResult } from 'lit';
import { customElement, property, query, state } from 'lit/decorators.js';
import { guard } from 'lit/directives/guard.js';
import { numbersOf } from '../algorithm/view.js';
import type { View } from '../algorithm/view.js';
import { base } from '../elements/theme.js';
import { Follower } from '../picture/in-sight.js';
import type { Trace } from '../replay/trace.js';
import './cpp.js';
import { valuesInPlay } from './in-play.js';
import { listingStyle } from './listing.style.js';
import { texts } from '../i18n/index.js';
import { deviationOf } from '../trace/editions.js';
import { listingsOf, wrongLines } from './listings.js';
import type { Line, Listing } from './listings.js';
import './wrong-lines.js';
import type { WrongLine, WrongLinesElement } from './wrong-lines.js';

/** The longest note that fits beside a line. */
const usual = 18;

interface LineKind {
  readonly now: boolean;
  readonly caller: boolean;
}

/** The procedures, with the current line and the lines that wait for a result. */
@customElement('vidno-listing')
export class ListingElement extends LitElement {
  static override styles = [base, listingStyle];

  @property({ attribute: false }) trace!: Trace;
  @property({ attribute: false }) view!: View;

  /** Whether lines can be broken. An event `vidno-break` asks for the run of an edition beside this one. */
  @property({ type: Boolean }) breakable = false;
  /** Whether the C++ code of the procedures is shown instead. */
  @state() private source = false;

  private listings: readonly Listing[] = [];
  private shown = '';
  private values: ReadonlyMap<string, string> = new Map();
  private callers: ReadonlySet<string | null> = new Set();
  private wrong: readonly WrongLine[] = [];
  @query('vidno-wrong-lines') private wrongLines!: WrongLinesElement;

  override willUpdate(): void {
    const { header, language } = this.view;
    const { method, edition, kernel, detail } = header;
    const shown = [method, edition, kernel, detail, language, this.breakable].join();
    if (shown === this.shown) return;
    this.shown = shown;
    this.listings = listingsOf(header, language);
    const wrong = this.breakable ? wrongLines(header) : new Map<string, never>();
    this.wrong = this.listings
      .flatMap(({ lines }) => lines)
      .flatMap(({ at, text }) => {
        const ways = wrong.get(at);
        return ways === undefined ? [] : [{ at, text, wrong: ways }];
      });
  }

  override render(): TemplateResult {
    const { texts, after } = this.view;
    return html`
      <div class="head">
        <ol class="calls" aria-label=${texts.callStack}>
          ${after.calls.map(({ of, at }) => html`<li>${of} <b>${at ?? ''}</b></li>`)}
        </ol>
        ${this.wrong.length > 0 ? this.breakButton() : nothing}
        <button
          aria-pressed=${this.source ? 'true' : 'false'}
          title=${texts.source}
          @click=${() => this.toggleSource()}
        >
          C++
        </button>
      </div>
      ${this.source ? html`<vidno-cpp .view=${this.view}></vidno-cpp>` : this.procedures()}
      <vidno-wrong-lines .language=${this.view.language} .lines=${this.wrong}></vidno-wrong-lines>
    `;
  }

  private breakButton(): TemplateResult {
    const { broken } = texts[this.view.language].compare;
    return html`<button
      class="break"
      title=${broken.explained}
      aria-label=${broken.offer}
      aria-haspopup="dialog"
      @click=${() => void this.wrongLines.show(null)}
    >
      ≠
    </button>`;
  }

  /** The mark of a line that can be broken, for the pointer. For the keyboard there is the button above the procedures. */
  private mark(at: string): TemplateResult | typeof nothing {
    if (!this.wrong.some((each) => each.at === at)) return nothing;
    const { broken } = texts[this.view.language].compare;
    return html`<i
      class="mark"
      aria-hidden="true"
      title=${broken.offerAt(at)}
      @click=${() => void this.wrongLines.show(at)}
    ></i>`;
  }

  toggleSource(): void {
    this.source = !this.source;
  }

  private procedures(): TemplateResult {
    this.values = valuesInPlay(this.trace, this.view.step, numbersOf(this.view));
    this.callers = new Set(this.view.after.calls.slice(0, -1).map(({ at }) => at));
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

  /** Whether the line is the current one, or waits for a result, or both. */
  private kindOf(at: string): LineKind {
    return { now: at === this.current, caller: this.callers.has(at) };
  }

  /** A procedure that was just called has no current line yet, so its name is marked. */
  private isEntered(name: string): boolean {
    const top = this.view.after.calls.at(-1);
    return this.view.event?.e === 'call' && top?.of === name;
  }

  /** The template of a procedure, cached because most steps change few procedures. */
  private procedure(listing: Listing): unknown {
    const { name, title, takes, lines } = listing;
    const isEntered = this.isEntered(name);
    const told = lines.map(({ at }) => {
      const { now, caller } = this.kindOf(at);
      return `${now} ${caller} ${this.values.get(at) ?? ''}`;
    });
    return guard(
      [listing, isEntered, ...told],
      () => html`
        <section class=${isEntered ? 'entered' : nothing}>
          <h3><span class="name">${name}</span>(${takes}) <span class="title">${title}</span></h3>
          <ol>
            ${lines.map((line) => this.line(line))}
          </ol>
        </section>
      `,
    );
  }

  private line({ at, indent, text, defects, speaks }: Line): TemplateResult {
    const { now, caller } = this.kindOf(at);
    return html`
      <li class=${caller ? 'caller' : now ? 'now' : ''} aria-current=${now ? 'step' : nothing}>
        <span class="at">${at}${this.mark(at)}</span>
        <code .style=${`--indent: ${indent}`}>${text}${speaks ? this.said(at) : nothing}</code>
        ${defects.map((id) => this.defect(id))}
      </li>
    `;
  }

  /** The last note of the line. Its place remains when it is empty, so that no line moves unless a note is long. */
  private said(at: string): TemplateResult {
    const said = this.values.get(at) ?? '';
    return html`<var class=${said.length > usual ? 'long' : ''} title=${said}>${said}</var>`;
  }

  private defect(id: string): TemplateResult {
    const { header, language, texts: say } = this.view;
    const says = deviationOf(header.edition)?.says[language] ?? say.defect(id);
    return html`<abbr class="defect" title=${says}>${id}</abbr>`;
  }

  override updated(changed: PropertyValues<this>): void {
    super.updated(changed);
    const find = (what: string): HTMLElement | null => this.renderRoot.querySelector(what);
    // Before the first step the listing is at its beginning.
    const mark = this.view.step === 0 ? find('section') : (find('.entered h3') ?? find('.now'));
    this.follower.follow(find('.procedures'), mark);
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'vidno-listing': ListingElement;
  }
}
