import { LitElement, css, html, nothing } from 'lit';
import type { PropertyValues, TemplateResult } from 'lit';
import { customElement, property, query, state } from 'lit/decorators.js';
import { guard } from 'lit/directives/guard.js';
import type { View } from '../algorithm/view.js';
import { isCorrected } from '../language/stated.js';
import { base } from '../elements/theme.js';
import { Follower } from '../picture/in-sight.js';
import type { Trace } from '../replay/trace.js';
import './cpp.js';
import { texts } from '../i18n/index.js';
import { deviationOf } from '../trace/editions.js';
import { listingsOf, wrongLines } from './listings.js';
import type { Line, Listing } from './listings.js';
import { textNames } from './text-names.js';
import './wrong-lines.js';
import type { WrongLine, WrongLinesElement } from './wrong-lines.js';

const listingStyle = css`
  :host {
    display: flex;
    flex-direction: column;
    min-height: 0;
  }
  ol {
    list-style: none;
  }
  .head {
    display: flex;
    flex: none;
    height: 2.6rem;
    padding: 0 0.5rem 0 0.75rem;
    border-bottom: 1px solid var(--line);
  }
  .head button {
    display: var(--tools, block);
    visibility: var(--quiet, visible);
    align-self: center;
    padding: 0 0.5rem;
    font: 600 0.75rem var(--mono);
  }
  .head button[aria-pressed='true'] {
    border-color: var(--accent);
    background: var(--accent-wash);
    color: var(--accent);
  }
  .calls {
    display: flex;
    flex: 1;
    flex-wrap: wrap;
    min-width: 0;
    align-content: center;
    overflow: hidden;
    white-space: nowrap;
    font-size: 0.75rem;
    line-height: 1.3;
    color: var(--soft);
  }
  .calls li + li::before {
    content: '›';
    margin: 0 0.5em;
  }
  .calls li:last-child {
    color: var(--ink);
  }
  .procedures {
    position: relative;
    flex: 1;
    min-height: 0;
    overflow: auto;
    padding-bottom: 0.75rem;
    scrollbar-width: thin;
  }
  .procedures:focus-visible {
    outline-offset: -3px;
  }
  h3 {
    margin-top: 0.6rem;
    padding: 0.2rem 0.75rem;
    font: 0.8125rem / 1.4 var(--mono);
    letter-spacing: 0;
  }
  .name {
    font-weight: 700;
    color: var(--ink);
  }
  .title {
    margin-left: 0.4em;
    font: 0.75rem var(--sans);
    white-space: nowrap;
  }
  .entered h3 {
    background: var(--now);
    box-shadow: inset 3px 0 var(--now-edge);
    color: var(--ink);
  }
  li {
    position: relative;
  }
  section li {
    display: grid;
    grid-template-columns: 2.5rem 1fr auto;
    align-items: baseline;
    padding: 0.14rem 0.75rem;
    font-size: 0.8125rem;
    line-height: 1.4;
  }
  .at {
    color: var(--soft);
    font: 0.6875rem var(--mono);
  }
  code {
    display: flow-root;
    padding-left: calc(var(--indent) * 1rem + 0.8rem);
    text-indent: -0.8rem;
    font-family: var(--sans);
    overflow-wrap: anywhere;
  }
  var {
    float: right;
    box-sizing: border-box;
    width: min(14rem, max(37%, min(60%, 8.75rem)));
    min-height: 1.4em;
    padding-left: 0.4rem;
    overflow: hidden;
    color: var(--accent);
    font: 0.75rem / 1.4 var(--mono);
    text-align: right;
    text-indent: 0;
    text-overflow: ellipsis;
    white-space: nowrap;
  }
  var.long {
    width: auto;
    max-width: 100%;
    overflow-wrap: anywhere;
    white-space: normal;
  }
  .now {
    background: var(--now);
    box-shadow: inset 3px 0 var(--now-edge);
  }
  .now.wrong {
    background: var(--bad-wash);
    box-shadow: inset 3px 0 var(--bad);
  }
  .now :is(.at, var) {
    color: inherit;
  }
  .mark {
    display: inline-block;
    width: 1.1em;
    margin-left: 0.15em;
    /* With opacity, the browser would composite each mark separately. */
    color: color-mix(in srgb, var(--soft) 55%, transparent);
    font: normal 0.75rem / 1 var(--mono);
    text-align: center;
    cursor: pointer;
  }
  /* Not part of the line's text, for copying and for screen readers. */
  .mark::after {
    content: '≠';
  }
  li:hover .mark,
  .now .mark {
    color: var(--accent);
  }
  @media (forced-colors: active) {
    .now .mark,
    .entered h3 *,
    [aria-current] :is(.at, var) {
      color: inherit;
    }
  }
  .break {
    margin-right: 0.35rem;
  }
  .caller {
    background: var(--caller);
    box-shadow: inset 3px 0 color-mix(in srgb, var(--now-edge) 45%, transparent);
  }
  @container (min-width: 1500px) {
    section li {
      font-size: 0.9375rem;
    }
    h3 {
      font-size: 0.9375rem;
    }
  }
  .defect {
    margin-left: 0.5rem;
    padding: 0 0.35em;
    border-radius: 4px;
    background: var(--bad-wash);
    color: var(--bad);
    font: 600 0.6875rem / 1.5 var(--mono);
    text-decoration: none;
    cursor: help;
  }
  details {
    margin: 0.9rem 0.75rem 0;
    color: var(--soft);
    font-size: 0.75rem;
  }
  summary {
    cursor: pointer;
  }
  dl {
    display: grid;
    grid-template-columns: minmax(0, 2fr) minmax(0, 3fr);
    gap: 0.3rem 0.9rem;
    margin-top: 0.4rem;
    overflow-wrap: anywhere;
  }
  dt,
  dd b {
    color: var(--ink);
    font-weight: 600;
  }
  dd {
    margin: 0;
  }
  :host([hall]) details {
    display: none;
  }
  :host([hall]) .head {
    height: 1.6rem;
  }
  /* A line below the last whole one fades, which shows that the procedure continues. */
  :host([hall]) .procedures {
    scroll-padding-bottom: 0.6rem;
    mask-image: linear-gradient(#000000 calc(100% - 0.6rem), transparent);
    scrollbar-width: none;
  }
  :host([hall]) :is(h3, section li) {
    font-size: 0.8125rem;
  }
  :host([hall]) h3 {
    margin-top: 0.3rem;
    padding-block: 0.1rem;
  }
  /* Less room is kept for notes: more lines are in sight. */
  :host([hall]) var {
    width: auto;
    min-width: 3.5rem;
    max-width: 60%;
  }
  :host([hall]) section li {
    padding-block: 0.1rem;
    line-height: 1.3;
  }
  :host([hall]) :is(.at, .defect) {
    font-size: 0.75rem;
  }
  /* Only the running procedures: those of the line and of its callers. */
  @media print {
    :is(.mark, details) {
      display: none;
    }
    .procedures {
      overflow: hidden;
    }
    section li {
      padding-block: 0;
    }
    .procedures:has(.now, .caller, .entered) section:not(:has(.now, .caller), .entered) {
      display: none;
    }
    .now {
      border: 0.5mm solid #000000;
      font-weight: 600;
    }
  }
`;

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

  /** The procedures and lines that are explained; null for all. The text of another line appears only while it runs. */
  @property({ attribute: false }) explained: readonly string[] | null = null;
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
    this.values = this.trace.timeline.notesAt(this.view.step, this.view.language);
    this.callers = new Set(this.view.after.calls.slice(0, -1).map(({ at }) => at));
    return html`<div
      class="procedures"
      tabindex="0"
      role="region"
      aria-label=${this.view.texts.listing}
    >
      ${this.listings.map((listing) => this.procedure(listing))} ${this.names()}
    </div>`;
  }

  private names(): unknown {
    const { header, language, texts } = this.view;
    return guard(
      [header.method, language],
      () => html`
        <details>
          <summary>${texts.textNames}</summary>
          <dl>
            ${textNames(header.method, language).map(
              ({ name, term, line }) =>
                html`<dt lang="ru">${name}</dt>
                  <dd><b>${term}</b> ${line}</dd>`,
            )}
          </dl>
        </details>
      `,
    );
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

  /** The current line is marked where it computes what is not so. */
  private get nowClass(): string {
    return isCorrected(this.view.sentence) ? 'now wrong' : 'now';
  }

  /** The template of a procedure, cached because most steps change few procedures. */
  private procedure(listing: Listing): unknown {
    const { name, title, takes, lines } = listing;
    const isEntered = this.isEntered(name);
    const rows = lines.map(({ at }) => {
      const { now, caller } = this.kindOf(at);
      return `${now ? this.nowClass : ''} ${caller} ${this.values.get(at) ?? ''}`;
    });
    return guard(
      [listing, isEntered, this.explained, ...rows],
      () => html`
        <section class=${isEntered ? 'entered' : nothing}>
          <h3><span class="name">${name}</span>(${takes}) <span class="title">${title}</span></h3>
          <ol>
            ${lines.map((line) => this.line(line, name))}
          </ol>
        </section>
      `,
    );
  }

  private line({ at, indent, text, defects, speaks }: Line, name: string): TemplateResult {
    const { now, caller } = this.kindOf(at);
    const { explained } = this;
    const isShown = now || explained === null || explained.includes(at) || explained.includes(name);
    const shown = isShown ? html`${text}${speaks ? this.said(at) : nothing}` : '…';
    return html`
      <li
        class=${caller ? 'caller' : now ? this.nowClass : ''}
        aria-current=${now ? 'step' : nothing}
      >
        <span class="at">${at}${this.mark(at)}</span>
        <code .style=${`--indent: ${indent}`}>${shown}</code>
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
    const procedure = this.view.step === 0 ? null : mark?.closest('section');
    const lines = procedure?.querySelectorAll<HTMLElement>('h3, li') ?? [];
    this.follower.follow(find('.procedures'), mark, 0, [...lines], this.view.step);
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'vidno-listing': ListingElement;
  }
}
