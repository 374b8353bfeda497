import { LitElement, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { classMap } from 'lit/directives/class-map.js';
import { texts } from '../i18n/index.js';
import type { RegionTexts } from '../i18n/region-texts.js';
import { short } from '../i18n/words.js';
import { polygonThing } from '../pointed.js';
import type { Piece } from '../regions/events.js';
import { areaOf, verticesOf } from '../regions/geometry.js';
import { emptyRegions } from '../regions/state.js';
import type { List, Regions } from '../regions/state.js';
import type { View } from '../view.js';
import { panelsStyle } from './panels.style.js';
import { polygonName, value } from './parts.js';
import { regionsPanelStyle } from './regions-panel.style.js';
import { base } from './theme.js';

const mostRows = 200;
const chips = 12;

/** The state of Weiler and Atherton's algorithm: the list in hand and its parts, what is visible, and the stack of lists. */
@customElement('vidno-regions')
export class RegionsPanel extends LitElement {
  static override styles = [base, panelsStyle, regionsPanelStyle];

  @property({ attribute: false }) view!: View;

  private get say(): RegionTexts {
    return texts[this.view.language].regions;
  }

  private get now(): Regions {
    return this.view.after.regions ?? emptyRegions;
  }

  private get old(): Regions {
    return this.view.before.regions ?? emptyRegions;
  }

  override render(): TemplateResult {
    const { say, now, old } = this;
    return html`${this.found()} ${this.inHand()}
      <section class="lists two">
        ${this.parts(say.inside, now.inHand?.inside ?? [], old.inHand?.inside ?? [], true)}
        ${this.parts(say.outside, now.inHand?.outside ?? [], old.inHand?.outside ?? [], false)}
      </section>
      ${this.visible()} ${this.stack()}`;
  }

  private found(): TemplateResult {
    const { say, now, old } = this;
    const { texts: page } = this.view;
    const clipOf = ({ inHand }: Regions): string | undefined => inHand?.pieces[0]?.[0];
    const clip = clipOf(now);
    return html`<section>
      <dl class="values">
        ${value(
          `C, ${say.clip}`,
          clip === undefined ? page.none : polygonName(clip, this.view),
          now.inHand?.pieces !== old.inHand?.pieces,
        )}
        ${value(say.lists, now.lists.length, now.lists.length !== old.lists.length)}
        ${value(say.shown, now.visible.length, now.visible !== old.visible)}
      </dl>
    </section>`;
  }

  /** The list that was taken from the stack; before there is one, what is to be sorted. */
  private inHand(): TemplateResult {
    const { say, now, old } = this;
    const { inHand, facets } = now;
    const title = inHand === null ? say.pieces : say.list;
    const pieces = inHand?.pieces ?? facets;
    const isOther = inHand?.seen !== old.inHand?.seen;
    return html`<section>
      <h3>${title}</h3>
      ${this.list(title, 'hand', pieces, (piece, i) => {
        const isLast = inHand !== null && i === inHand.seen - 1;
        return this.row(piece, this.roleOf(i), isLast && isOther);
      })}
    </section>`;
  }

  /** What became of a piece of the list in hand. */
  private roleOf(index: number): string {
    const { say, now } = this;
    const { inHand } = now;
    if (inHand === null) return '';
    if (index === 0) return `C, ${say.clip}`;
    return index < inHand.seen ? '✓' : '';
  }

  private parts(title: string, now: List, old: List, isInside: boolean): TemplateResult {
    const fresh = now.length > old.length ? now.length - 1 : -1;
    return html`<div>
      <h4>${title}</h4>
      ${this.list(title, 'short', now, (piece, i) =>
        this.row(piece, isInside ? this.orderOf(now, i) : '', i === fresh, true),
      )}
    </div>`;
  }

  /** How a part inside lies to the clip polygon, where that is known. */
  private orderOf(inside: List, index: number): string {
    const { say, now } = this;
    if (inside[index]?.[2] === true) return '';
    const place = inside.slice(0, index).filter(([, , ground]) => !ground).length;
    const behind = now.inHand?.behind[place];
    if (behind === undefined) return '';
    return behind ? say.behind : say.nearer;
  }

  private visible(): TemplateResult {
    const { say, now, old } = this;
    const shown = [...now.visible].reverse();
    const isFresh = now.visible !== old.visible;
    return html`<section>
      <h3>${say.visible}</h3>
      ${this.list(say.visible, 'visible', shown, (piece, i) =>
        this.row(piece, `${say.area} ${short(areaOf(piece[1]))}`, i === 0 && isFresh),
      )}
    </section>`;
  }

  private list(
    label: string,
    look: string,
    pieces: List,
    row: (piece: Piece, index: number) => TemplateResult,
  ): TemplateResult {
    return html`<div class="list ${look}" tabindex="0" role="region" aria-label=${label}>
      <table class="rows">
        <tbody>
          ${pieces.slice(0, mostRows).map(row)}
        </tbody>
      </table>
      ${this.emptyOrMore(pieces.length)}
    </div>`;
  }

  /** In a narrow list what is known of a piece stands in place of its size. */
  private row(
    [id, region, ground]: Piece,
    known: string,
    changed: boolean,
    isNarrow = false,
  ): TemplateResult {
    const { say } = this;
    const thing = polygonThing(id);
    const pointed = thing === this.view.pointed;
    const said = ground ? say.ground : known;
    const size = `${verticesOf(region)} ${say.vertices}${region.length > 1 ? `, ${say.loops(region.length)}` : ''}`;
    return html`<tr class=${classMap({ pointed })} data-thing=${thing}>
      <td class=${classMap({ changed })}>${polygonName(id, this.view)}</td>
      ${isNarrow && said !== '' ? nothing : html`<td class="said" title=${size}>${size}</td>`}
      ${isNarrow && said === '' ? nothing : html`<td class="said">${said}</td>`}
    </tr>`;
  }

  private stack(): TemplateResult {
    const { say, now, old } = this;
    const fresh = now.lists.length > old.lists.length;
    const shown = [...now.lists].reverse().slice(0, mostRows);
    return html`<section class="stack">
      <h3>${say.lists}</h3>
      <table class="rows">
        <tbody>
          ${shown.map((list, i) => this.stacked(list, i === 0 && fresh))}
        </tbody>
      </table>
      ${this.emptyOrMore(now.lists.length)}
    </section>`;
  }

  private stacked(list: List, changed: boolean): TemplateResult {
    return html`<tr>
      <td class=${classMap({ number: true, changed })}>${list.length}</td>
      <td class="chips">
        ${list
          .slice(0, chips)
          .map(([id]) => html`<span class="chip">${polygonName(id, this.view)}</span>`)}
      </td>
    </tr>`;
  }

  private emptyOrMore(length: number): TemplateResult | typeof nothing {
    const { texts: page } = this.view;
    if (length === 0) return html`<p class="empty">${page.empty}</p>`;
    return length > mostRows ? html`<p class="empty">${page.more(length - mostRows)}</p>` : nothing;
  }
}
