import { LitElement, css, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { classMap } from 'lit/directives/class-map.js';
import { polygonThing } from '../algorithm/pointed.js';
import { numbersOf } from '../algorithm/view.js';
import type { View } from '../algorithm/view.js';
import { chipsCell, listOf, rowsOf } from '../elements/lists.js';
import { panelsStyle } from '../elements/panels.style.js';
import { polygonName, value } from '../elements/parts.js';
import { base } from '../elements/theme.js';
import { countedIn, texts } from '../i18n/index.js';
import type { RegionTexts } from '../language/texts.js';
import type { WeilerAtherton } from '../replay/values.js';
import type { Piece, Region } from '../trace/values.js';
import { areaOf, verticesOf } from './geometry.js';
import { emptyWeilerAtherton, isPainting, currentListOf } from './state.js';
import type { List, CurrentList } from './state.js';

const regionsPanelStyle = css`
  .values.found {
    grid-template-columns: minmax(min-content, 1.45fr) minmax(min-content, 1.25fr) minmax(
        min-content,
        0.85fr
      );
    gap: 0.35rem 0.6rem;
    align-items: end;
  }
  .found dt {
    white-space: normal;
  }
  .lists.two {
    grid-template-columns: minmax(0, 1fr) minmax(0, 1fr);
  }
  .list.short {
    height: 4.9rem;
  }
  .list.current {
    height: 6.6rem;
  }
  .list.visible {
    height: 8.2rem;
  }
  .rows td.said {
    font-size: 0.75rem;
    line-height: 1.3;
    color: var(--soft);
    white-space: normal;
  }
  .rows td.number {
    text-align: right;
  }
  :host([hall]) {
    display: grid;
    grid: auto-flow dense / minmax(0, 1fr) minmax(0, 1fr);
  }
  :host([hall]) :is(.sizes, .lists) {
    grid-column: 1 / -1;
  }
  :host([hall]) .values.found {
    grid-template-columns: minmax(0, 2fr) minmax(0, 1fr) minmax(0, 1fr);
    gap: 0 0.75rem;
  }
  :host([hall]) .lists {
    gap: 0 0.75rem;
  }
  /* The number of lists is above. */
  :host([hall]) .stack {
    display: none;
  }
`;

/**
 * The state of Weiler and Atherton's algorithm: the current list and its parts, the visible regions, and the stack of
 * lists.
 */
@customElement('vidno-regions')
export class RegionsPanel extends LitElement {
  static override styles = [base, panelsStyle, regionsPanelStyle];

  @property({ attribute: false }) view!: View;

  private get say(): RegionTexts {
    return texts[this.view.language].regions;
  }

  private get now(): WeilerAtherton {
    return this.view.after.weilerAtherton ?? emptyWeilerAtherton;
  }

  private get old(): WeilerAtherton {
    return this.view.before.weilerAtherton ?? emptyWeilerAtherton;
  }

  private get current(): CurrentList | null {
    return currentListOf(this.view);
  }

  /** The list before the step; null once regions are painted. */
  private get previous(): CurrentList | null {
    return isPainting(this.view) ? null : this.old.currentList;
  }

  override render(): TemplateResult {
    const { say, current, previous } = this;
    return html`${this.found()} ${this.currentList()}
      <section class="lists two" data-part="parts">
        ${this.parts(say.inside, current?.inside ?? [], previous?.inside ?? [], true)}
        ${this.parts(say.outside, current?.outside ?? [], previous?.outside ?? [], false)}
      </section>
      ${this.visible()} ${this.stack()}`;
  }

  private found(): TemplateResult {
    const { say, now, old, current, previous } = this;
    const { texts: page } = this.view;
    const clip = current?.pieces[0]?.[0];
    return html`<section class="sizes" data-part="list">
      <dl class="values found">
        ${value(
          `C, ${say.clip}`,
          clip === undefined ? page.none : polygonName(clip, this.view),
          current?.pieces !== previous?.pieces,
        )}
        ${value(say.lists, now.lists.length, now.lists.length !== old.lists.length)}
        ${value(say.shown, now.visible.length, now.visible !== old.visible)}
      </dl>
    </section>`;
  }

  /** The list that was popped from the stack, or before the first one the list to sort. */
  private currentList(): TemplateResult {
    const { say, now, current, previous } = this;
    const title = now.currentList === null ? say.pieces : say.list;
    const pieces = current?.pieces ?? (now.currentList === null ? now.facets : []);
    const isOther = current?.seen !== previous?.seen;
    const row = (piece: Piece, i: number): TemplateResult =>
      this.row(piece, this.roleOf(i), isOther && i + 1 === current?.seen);
    return html`<section data-part="list">
      <h3>${title}</h3>
      ${listOf(title, 'current', pieces, row, this.view)}
    </section>`;
  }

  /** The result for a piece of the current list. */
  private roleOf(index: number): string {
    const { say, current } = this;
    if (current === null) return '';
    if (index === 0) return `C, ${say.clip}`;
    return index < current.seen ? '✓' : '';
  }

  private parts(title: string, now: List, old: List, isInside: boolean): TemplateResult {
    const fresh = now.length > old.length ? now.length - 1 : -1;
    const row = (piece: Piece, i: number): TemplateResult =>
      this.row(piece, isInside ? this.orderOf(now, i) : '', i === fresh, true);
    return html`<div>
      <h4>${title}</h4>
      ${listOf(title, 'short', now, row, this.view)}
    </div>`;
  }

  /** The order of an inside part relative to the clip polygon, if it is known. */
  private orderOf(inside: List, index: number): string {
    const { say, current } = this;
    if (inside[index]?.[2] === true) return '';
    const place = inside.slice(0, index).filter(([, , ground]) => !ground).length;
    const behind = current?.behind[place];
    if (behind === undefined) return '';
    return behind ? say.behind : say.nearer;
  }

  private visible(): TemplateResult {
    const { say, now, old } = this;
    const shown = [...now.visible].reverse();
    const isFresh = now.visible !== old.visible;
    const row = (piece: Piece, i: number): TemplateResult =>
      this.row(
        piece,
        `${say.area} ${numbersOf(this.view).short(areaOf(piece[1]))}`,
        i === 0 && isFresh,
      );
    return html`<section data-part="visible">
      <h3>${say.visible}</h3>
      ${listOf(say.visible, 'visible', shown, row, this.view)}
    </section>`;
  }

  /** In a narrow list the result for a piece replaces its size. */
  private row(
    [id, region, ground]: Piece,
    known: string,
    changed: boolean,
    isNarrow = this.view.hall === true,
  ): TemplateResult {
    const { say } = this;
    const thing = polygonThing(id);
    const pointed = thing === this.view.pointed;
    const said = ground ? say.ground : known;
    const size = this.sized(region);
    return html`<tr class=${classMap({ pointed })} data-thing=${thing}>
      <td class=${classMap({ changed })}>${polygonName(id, this.view)}</td>
      ${isNarrow && said !== '' ? nothing : html`<td class="said">${size}</td>`}
      ${isNarrow && said === '' ? nothing : html`<td class="said">${said}</td>`}
    </tr>`;
  }

  /** "8 vertices, 2 loops". */
  private sized(region: Region): string {
    const { language } = this.view;
    const { vertices, loops } = this.say;
    const size = countedIn(language, verticesOf(region), vertices);
    return region.length > 1 ? `${size}, ${countedIn(language, region.length, loops)}` : size;
  }

  private stack(): TemplateResult {
    const { say, now, old } = this;
    const fresh = now.lists.length > old.lists.length;
    const shown = [...now.lists].reverse();
    return html`<section class="stack" data-part="stack">
      <h3>${say.lists}</h3>
      ${rowsOf(shown, (list, i) => this.stacked(list, i === 0 && fresh), this.view)}
    </section>`;
  }

  private stacked(list: List, changed: boolean): TemplateResult {
    const ids = list.map(([id]) => id);
    return html`<tr>
      <td class=${classMap({ number: true, changed })}>${list.length}</td>
      ${chipsCell(ids, this.view)}
    </tr>`;
  }
}
