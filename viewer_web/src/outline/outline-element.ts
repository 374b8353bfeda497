import { LitElement, css, html, nothing, svg } from 'lit';
import type { PropertyValues, TemplateResult } from 'lit';
import { customElement, property, query, state } from 'lit/decorators.js';
import { guard } from 'lit/directives/guard.js';
import { repeat } from 'lit/directives/repeat.js';
import type { View } from '../algorithm/view.js';
import { ReadOn } from '../elements/read-on.js';
import { base, hiddenStyle } from '../elements/theme.js';
import { countedIn, texts } from '../i18n/index.js';
import type { OutlineTexts } from '../language/texts.js';
import type { Trace } from '../replay/trace.js';
import type { Command } from '../time/travel.js';
import { cases } from '../time/course.js';
import { around, indexFrom } from '../time/goals.js';
import { outlineOf, sayNode } from './outline.js';
import type { Outline } from './outline.js';
import { facetsOf, proceduresOf, sayTerm, termsOf, without, written } from './query.js';
import type { Facet, Term } from './query.js';
import { Search } from './search.js';
import { none } from './table.js';
import { treeKeys } from './tree-keys.js';
import { Unfolded } from './unfolded.js';

/** A search, and below it the scrolling tree. All rows have the same height, so the element can compute their positions. */
const outlineStyle = css`
  :host {
    display: flex;
    flex-direction: column;
    min-height: 0;
    contain: strict;
  }
  .hint {
    flex: none;
    padding: 0.5rem 0.75rem;
    color: var(--soft);
  }
  .example {
    color: var(--soft);
  }
  .search {
    display: grid;
    flex: none;
    grid-template-columns: minmax(0, 1fr) auto auto;
    gap: 0.35rem;
    align-items: center;
    padding: 0.5rem 0.6rem;
    border-bottom: 1px solid var(--line);
  }
  input {
    width: 100%;
    min-width: 0;
    min-height: 2rem;
    padding: 0 0.5rem;
    border: 1px solid var(--line);
    border-radius: 6px;
    background: var(--panel);
    color: var(--ink);
    font: inherit;
    font-size: 0.8125rem;
  }
  .search button {
    display: grid;
    place-items: center;
    width: 2rem;
    padding: 0;
  }
  button[aria-disabled='true'] {
    opacity: 0.55;
  }
  svg {
    width: 1rem;
    height: 1rem;
    fill: none;
    stroke: currentColor;
    stroke-width: 2;
    stroke-linecap: round;
    stroke-linejoin: round;
  }
  .found {
    display: flex;
    grid-column: 1 / -1;
    flex-wrap: wrap;
    gap: 0.25rem 0.35rem;
    align-items: center;
    min-height: 1.5rem;
    font-size: 0.75rem;
  }
  .found [role='status'] {
    margin-left: auto;
    color: var(--soft);
    font-variant-numeric: tabular-nums;
  }
  .search .chip {
    display: flex;
    gap: 0.35rem;
    width: auto;
    min-height: 1.5rem;
    padding: 0 0.5rem;
    border-radius: 0.75rem;
    background: var(--accent-wash);
    font-size: 0.75rem;
    overflow-wrap: anywhere;
  }
  .search .chip.unknown {
    border-color: var(--bad);
    background: var(--bad-wash);
    color: var(--bad);
  }
  .tree {
    position: relative;
    flex: 1;
    min-height: 0;
    overflow: auto;
    scrollbar-width: thin;
  }
  .tree:focus-visible {
    outline-offset: -3px;
  }
  .rows {
    position: relative;
    overflow: hidden;
  }
  .row {
    position: absolute;
    inset: 0 0 auto;
    display: flex;
    gap: 0.3rem;
    align-items: center;
    height: var(--row);
    padding: 0 0.6rem 0 calc(0.3rem + min(var(--depth), 12) * 0.7rem);
    font-size: 0.8125rem;
    line-height: 1.2;
    white-space: nowrap;
    cursor: pointer;
    contain: strict;
  }
  .row:hover {
    background: var(--well);
  }
  .fold {
    flex: none;
    display: grid;
    place-items: center;
    width: 1.1rem;
    height: 100%;
    color: var(--soft);
  }
  .fold svg {
    width: 0.75rem;
    height: 0.75rem;
  }
  [aria-expanded='true'] > .fold svg {
    transform: rotate(90deg);
  }
  .said {
    flex: 1;
    min-width: 0;
    overflow: hidden;
    text-overflow: ellipsis;
  }
  .step {
    flex: none;
    color: var(--soft);
    font-size: 0.6875rem;
  }
  .hit .said {
    font-weight: 600;
    text-decoration: underline 2px var(--accent);
    text-underline-offset: 0.2em;
  }
  .now,
  .now:hover {
    background: var(--now);
    box-shadow: inset 3px 0 var(--now-edge);
  }
  .now .step,
  .now .fold {
    color: inherit;
  }
  .tree:focus-visible .focused {
    outline: 2px solid var(--accent);
    outline-offset: -2px;
  }
  @media (forced-colors: active) {
    .now {
      outline: 3px solid Highlight;
      outline-offset: -3px;
    }
  }
`;

/** Milliseconds per frame for reading a run or searching it. */
const mostPerFrame = 6;
/** The height of a row, in rem. */
const rowHeight = 1.5;
/** The number of rows rendered beyond those in sight. */
const spare = 4;
/** The number of row texts in the cache. */
const mostSaid = 4000;
/** More polygons than this are not suggested. */
const mostOffered = 200;

/**
 * The outline of a run as a searchable tree, which marks the current step and keeps it in sight. Choosing a row goes to its
 * step. An event `hits` carries the steps found, an event `search` the query.
 */
@customElement('vidno-outline')
export class OutlineElement extends LitElement {
  static override styles = [base, hiddenStyle, outlineStyle];

  @property({ attribute: false }) trace!: Trace;
  @property({ attribute: false }) view!: View;
  /** The query; the owner of this element stores it. */
  @property({ attribute: false }) sought = '';
  /** Whether everything after the step is hidden. */
  @property({ type: Boolean }) veiled = false;
  /** The node of the keyboard cursor; `none` for that of the step. */
  @state() private cursor = none;
  @query('.tree') private tree!: HTMLElement | null;
  @query('input') private field!: HTMLInputElement | null;

  private outline!: Outline;
  private unfolded!: Unfolded;
  private search: Search | null = null;
  private readonly reader = new ReadOn(this, mostPerFrame);
  private readonly said = new Map<number, string>();
  /** The known scroll position of the tree. Reading it from the browser would force a layout. */
  private top = 0;
  private height = 0;
  private row = 24;
  private frame = 0;
  private step = -1;
  private shownHits: readonly number[] = [];
  /** The search whose hits were reported. */
  private shownSearch: Search | null = null;
  private observed: Element | null = null;

  private readonly observer = new ResizeObserver(([entry]) => {
    if (entry === undefined) return;
    this.height = entry.contentRect.height;
    this.row = rowHeight * parseFloat(getComputedStyle(document.documentElement).fontSize);
    this.step = -1;
    this.requestUpdate();
  });

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    cancelAnimationFrame(this.frame);
    this.observer.disconnect();
    this.observed = null;
  }

  private get texts(): OutlineTexts {
    return texts[this.view.language].outline;
  }

  /** Moves the focus to the tree. */
  override focus(): void {
    this.tree?.focus();
  }

  override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has('trace')) this.open();
    if (changed.has('view') && changed.get('view')?.language !== this.view.language)
      this.said.clear();
    if (changed.has('sought') || changed.has('trace')) this.seek();
    this.reader.read(this);
    this.followStep();
  }

  /** Continues to read the run, then to search it. */
  read(milliseconds: number): boolean {
    const { outline, trace, search } = this;
    if (!outline.isUpToDate) {
      this.step = -1;
      if (!outline.read(milliseconds)) return false;
    }
    if (!trace.complete || search === null) return true;
    if (search === this.shownSearch) return true;
    if (!search.read(milliseconds)) return false;
    this.shownSearch = search;
    this.tellHits(search.hits);
    return true;
  }

  private open(): void {
    this.outline = outlineOf(this.trace);
    this.unfolded = new Unfolded(this.outline);
    this.said.clear();
    this.cursor = none;
    this.step = -1;
    this.top = 0;
  }

  private seek(): void {
    const terms = termsOf(this.sought, this.view.header);
    this.search = terms.length === 0 ? null : new Search(this.outline, terms);
    this.tellHits([]);
  }

  private tellHits(nodes: readonly number[]): void {
    const { first } = this.outline.nodes;
    if (nodes.length === 0 && this.shownHits.length === 0) return;
    this.shownHits = nodes.map((node) => first[node] ?? 0);
    this.dispatchEvent(new CustomEvent<readonly number[]>('hits', { detail: this.shownHits }));
  }

  /** When the step has changed, scrolls its row into view. */
  private followStep(): void {
    const { step } = this.view;
    if (step === this.step) return;
    this.step = step;
    this.cursor = none;
    const at = this.outline.at(step);
    this.unfolded.follow(at);
    this.bringInSight(this.unfolded.rowOf(at));
  }

  /** Scrolls in the next frame, and only if the row is out of sight. */
  private bringInSight(row: number): void {
    const { height, row: tall, top } = this;
    const at = row * tall;
    if (row < 0 || height === 0 || (at >= top && at + 2 * tall <= top + height)) return;
    const end = Math.max(0, this.unfolded.length * tall - height);
    this.top = Math.min(Math.max(0, at - height / 3), end);
    cancelAnimationFrame(this.frame);
    this.frame = requestAnimationFrame(() => {
      if (this.tree !== null) this.tree.scrollTop = this.top;
    });
  }

  override render(): TemplateResult {
    if (this.veiled) return html`<p class="hint">${this.texts.veiled}</p>`;
    return html`${this.searching()}${this.shownTree()}`;
  }

  private shownTree(): TemplateResult {
    const { unfolded, row, outline } = this;
    const { length } = unfolded;
    const at = outline.at(this.view.step);
    const now = unfolded.nodeAt(unfolded.rowOf(at));
    const cursor = this.cursor === none ? now : unfolded.nodeAt(unfolded.rowOf(this.cursor));
    const first = Math.max(0, Math.floor(this.top / row) - spare);
    const end = Math.min(length, Math.ceil((this.top + this.height) / row) + spare);
    const cursorRow = unfolded.rowOf(cursor);
    const isCursorThere = cursorRow >= first && cursorRow < end;
    return html`${outline.complete ? nothing : html`<p class="hint" role="status">${this.texts.reading}</p>`}
      <div
        class="tree"
        role="tree"
        tabindex="0"
        aria-label=${this.texts.tree}
        aria-busy=${outline.complete ? 'false' : 'true'}
        aria-activedescendant=${isCursorThere ? `node-${cursor}` : nothing}
        @keydown=${this.onKey}
        @scroll=${this.onScroll}
        @click=${this.onClick}
      >
        <div class="rows" role="none" .style=${`height: ${length * row}px; --row: ${row}px`}>
          ${guard(
            [
              outline,
              unfolded.version,
              first,
              end,
              row,
              now,
              cursor,
              this.view.language,
              this.search?.complete,
              this.search,
            ],
            () => this.rows(first, end, now, cursor),
          )}
        </div>
      </div>`;
  }

  private rows(first: number, end: number, now: number, cursor: number): unknown {
    const { unfolded, outline } = this;
    const nodes = Array.from({ length: Math.max(0, end - first) }, (_, i) =>
      unfolded.nodeAt(first + i),
    );
    const hits = this.search?.hits ?? [];
    const { nodes: table } = outline;
    return repeat(
      nodes,
      (node) => node,
      (node, i) => {
        const parent = table.parent[node] ?? none;
        const children = table.children[node] ?? 0;
        const isHit = hits[indexFrom(hits, node)] === node;
        const look = [
          node === now ? 'now' : '',
          node === cursor ? 'focused' : '',
          isHit ? 'hit' : '',
        ];
        return html`<div
          class="row ${look.join(' ')}"
          role="treeitem"
          id="node-${node}"
          data-node=${node}
          aria-level=${table.depth[node] ?? 1}
          aria-posinset=${table.place[node] ?? 1}
          aria-setsize=${parent === none ? outline.topSize : (table.children[parent] ?? 1)}
          aria-expanded=${children === 0 ? nothing : unfolded.isUnfolded(node) ? 'true' : 'false'}
          aria-current=${node === now ? 'step' : nothing}
          .style=${`transform: translateY(${(first + i) * this.row}px); --depth: ${(table.depth[node] ?? 1) - 1}`}
        >
          <span class="fold" aria-hidden="true">${children === 0 ? nothing : arrow}</span>
          <span class="said" title=${this.say(node)}>${this.say(node)}</span>
          <span class="step number" aria-hidden="true">${table.first[node]}</span>
        </div>`;
      },
    );
  }

  private say(node: number): string {
    const known = this.said.get(node);
    if (known !== undefined) return known;
    if (this.said.size >= mostSaid) this.said.clear();
    const said = sayNode(this.outline, node, this.view.language);
    if (this.outline.complete) this.said.set(node, said);
    return said;
  }

  private searching(): TemplateResult {
    const { texts: say, search, view } = this;
    const { header, language } = view;
    const terms = search?.terms ?? [];
    return html`<div class="search" role="search" @keydown=${this.onSearchKey}>
      <input
        type="search"
        list="terms"
        spellcheck="false"
        autocomplete="off"
        aria-label=${say.search}
        placeholder=${say.search}
        .value=${this.sought}
        @input=${this.onInput}
      />
      ${this.hitButton(-1)} ${this.hitButton(1)}
      <div class="found">
        ${terms.length === 0 ? html`<span class="example">${say.example(this.examples())}</span>` : nothing}
        ${terms.map((term) => this.chip(term))}
        <span role="status">${this.counted()}</span>
      </div>
      <datalist id="terms">
        ${guard([header, language], () => this.offered().map((each) => html`<option value=${each}></option>`))}
      </datalist>
    </div>`;
  }

  private chip(term: Term): TemplateResult {
    const { texts: say, view } = this;
    const isKnown = term.meanings.length > 0;
    const label = isKnown ? sayTerm(term, view.header, view.language) : say.nothing(term.word);
    return html`<button
      class="chip ${isKnown ? '' : 'unknown'}"
      title=${say.remove(label)}
      aria-label=${say.remove(label)}
      @click=${() => this.look(without(this.search?.terms ?? [], term))}
    >
      ${label} <span aria-hidden="true">✕</span>
    </button>`;
  }

  /** Suggestions for the search field. */
  private offered(): readonly string[] {
    const { header, language } = this.view;
    const named = (facet: Facet): readonly string[] => {
      if (facet === 'case') return cases.map((name) => texts[language].strip.cases[name]);
      if (facet === 'procedure') return proceduresOf(header.method);
      if (facet !== 'polygon') return [];
      return header.scene.polygons.slice(0, mostOffered).map(({ id }) => id);
    };
    return facetsOf(header).flatMap((facet) =>
      named(facet).map((name) => written(facet, name, language)),
    );
  }

  private examples(): string {
    const { header, language } = this.view;
    const { facets } = texts[language].outline;
    const offered = this.offered();
    const examples = facetsOf(header).flatMap(
      (facet) => offered.filter((term) => term.startsWith(`${facets[facet]}:`)).at(-1) ?? [],
    );
    return examples.join(' ');
  }

  private counted(): string {
    const { search, texts: say, shownHits } = this;
    const { language, step } = this.view;
    if (search === null) return '';
    if (!search.complete || !this.trace.complete) return say.searching;
    if (shownHits.length === 0) return say.noHits;
    const hits = countedIn(language, shownHits.length, say.hits);
    const at = shownHits.indexOf(step);
    return at < 0 ? hits : say.hitOf(String(at + 1), hits);
  }

  private hitButton(by: -1 | 1): TemplateResult {
    const { texts: say } = this;
    const label = by === 1 ? say.nextHit : say.previousHit;
    const { back, forward } = around(this.shownHits, this.view.step);
    return html`<button
      class=${by === 1 ? 'next' : 'previous'}
      aria-label=${label}
      title="${label} (${by === 1 ? 'Enter' : 'Shift Enter'})"
      aria-disabled=${(by === 1 ? forward : back) === null ? 'true' : 'false'}
      @click=${() => this.goToHit(by)}
    >
      <svg viewBox="0 0 20 20" aria-hidden="true">
        ${by === 1 ? svg`<path d="M4 7l6 6 6-6" />` : svg`<path d="M4 13l6-6 6 6" />`}
      </svg>
    </button>`;
  }

  private goToHit(by: -1 | 1): void {
    const { back, forward } = around(this.shownHits, this.view.step);
    const step = by === 1 ? forward : back;
    if (step === null) return;
    this.cursor = none;
    this.goTo(step);
  }

  private goTo(step: number): void {
    this.dispatchEvent(new CustomEvent<Command>('command', { detail: { do: 'seek', step } }));
  }

  private look(query: string): void {
    this.sought = query;
    this.dispatchEvent(new CustomEvent<string>('search', { detail: query }));
    this.field?.focus();
  }

  private readonly onInput = (event: Event): void => {
    this.look((event.target as HTMLInputElement).value);
  };

  private readonly onSearchKey = (event: KeyboardEvent): void => {
    const isField = event.target === this.field;
    if (event.key === 'Enter' && isField) this.goToHit(event.shiftKey ? -1 : 1);
    else if (event.key === 'ArrowDown' && isField) this.focus();
    else if (event.key === 'Escape' && this.sought !== '') this.look('');
    else return;
    event.preventDefault();
  };

  private readonly onScroll = (event: Event): void => {
    const { scrollTop } = event.target as HTMLElement;
    if (scrollTop === this.top) return;
    this.top = scrollTop;
    this.requestUpdate();
  };

  private readonly onClick = (event: MouseEvent): void => {
    const node = nodeOf(event);
    if (node === none) return;
    const isFold = event
      .composedPath()
      .some((each) => each instanceof Element && each.classList.contains('fold'));
    this.unfolded.keep();
    this.cursor = node;
    if (isFold) this.toggle(node);
    else this.choose(node);
  };

  private choose(node: number): void {
    this.unfolded.keep();
    this.goTo(this.outline.nodes.first[node] ?? 0);
  }

  private toggle(node: number): void {
    const { unfolded, outline } = this;
    if ((outline.nodes.children[node] ?? 0) === 0) return;
    if (unfolded.isUnfolded(node)) unfolded.fold(node);
    else unfolded.unfold(node);
    this.requestUpdate();
  }

  private readonly onKey = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.shiftKey && event.key !== '*') return;
    const { outline, unfolded } = this;
    const now = unfolded.nodeAt(Math.max(0, unfolded.rowOf(outline.at(this.view.step))));
    const from = this.cursor === none ? now : this.cursor;
    if (event.code === 'Slash') this.field?.focus();
    else if (event.key === 'Enter') this.choose(from);
    else {
      const page = Math.max(1, Math.floor(this.height / this.row) - 1);
      const to = treeKeys(event.key, from, page, unfolded);
      if (to === null) return;
      this.cursor = to;
      this.bringInSight(unfolded.rowOf(to));
      this.requestUpdate();
    }
    event.preventDefault();
  };

  override updated(): void {
    const { tree } = this;
    if (tree === this.observed) return;
    this.observer.disconnect();
    this.observed = tree;
    if (tree !== null) this.observer.observe(tree);
  }
}

const arrow = html`<svg viewBox="0 0 12 12">${svg`<path d="M4 2l4 4-4 4" />`}</svg>`;

/** The node of the row under an event. */
function nodeOf(event: Event): number {
  const row = event
    .composedPath()
    .find((each) => each instanceof HTMLElement && 'node' in each.dataset);
  return row instanceof HTMLElement ? Number(row.dataset['node']) : none;
}
