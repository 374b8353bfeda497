import { LitElement, css, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { classMap } from 'lit/directives/class-map.js';
import { edgeThing } from '../algorithm/pointed.js';
import { numbersOf } from '../algorithm/view.js';
import type { View } from '../algorithm/view.js';
import { rowsShown } from '../elements/lists.js';
import { panelsStyle } from '../elements/panels.style.js';
import { isSet, numberCell, polygonName, value } from '../elements/parts.js';
import { base } from '../elements/theme.js';
import type { N } from '../trace/values.js';
import './depths.js';
import { emptyZBuffer } from './state.js';
import type { ActiveEdge, ZBuffer } from './state.js';

/** The state of the Z-buffer algorithm: the scanline, S, AEL, and the depths around the scanline. */
@customElement('vidno-zbuffer')
export class ZBufferPanel extends LitElement {
  static override styles = [
    base,
    panelsStyle,
    css`
      .values .wide dt {
        white-space: normal;
      }
      :host([hall]) .values {
        grid-template-columns: repeat(5, minmax(0, 1fr));
      }
      :host([hall]) .ael th:first-child {
        width: 3.2rem;
      }
      :host([hall]) .values .wide {
        display: flex;
        gap: 0.6rem;
        align-items: center;
        height: 1.25rem;
      }
      :host([hall]) .ael {
        --heads: 1;
      }
    `,
  ];

  @property({ attribute: false }) view!: View;

  private get now(): ZBuffer {
    return this.view.after.zbuffer ?? emptyZBuffer;
  }

  private get old(): ZBuffer {
    return this.view.before.zbuffer ?? emptyZBuffer;
  }

  override render(): TemplateResult {
    const { texts } = this.view;
    return html`
      ${this.scanline()}
      <section data-part="active-edges">
        <h3>${texts.ael}</h3>
        <div class="list ael" tabindex="0" role="region" aria-label=${texts.ael}>${this.ael()}</div>
      </section>
      <section data-part="z-buffer">
        <h3>${texts.depths}</h3>
        <vidno-depths .view=${this.view} ?hall=${this.view.hall}></vidno-depths>
      </section>
    `;
  }

  private scanline(): TemplateResult {
    const { now, old } = this;
    const { texts } = this.view;
    const { short } = numbersOf(this.view);
    const number = (n: N | null): string => (n === null ? texts.none : short(n));
    const polygon = now.polygon === null ? texts.none : polygonName(now.polygon, this.view);
    return html`<section data-part="scanline">
      <dl class="values">
        ${value('P', polygon, now.polygon !== old.polygon)}
        ${value(texts.row, number(now.row), isSet(now.row, old.row))}
        ${value('yₜ', number(now.y), isSet(now.y, old.y))}
        ${value('ySnext', number(now.nextS), isSet(now.nextS, old.nextS))}
        ${value('yAELnext', number(now.nextAel), isSet(now.nextAel, old.nextAel))}
        ${value(texts.unsorted, edgeList(now.edges, texts.none), now.edges !== old.edges, 'wide')}
      </dl>
    </section>`;
  }

  private ael(): TemplateResult {
    const { texts } = this.view;
    const { ael } = this.now;
    const shown = rowsShown(ael.length, this.view);
    return html`<table class="rows">
        <thead>
          <tr>
            <th scope="col">${texts.edge}</th>
            <th scope="col">x</th>
            <th scope="col">z</th>
            <th scope="col">${texts.until}</th>
            <th scope="col">Δx</th>
            <th scope="col">Δz</th>
          </tr>
        </thead>
        <tbody>
          ${ael.slice(0, shown).map((entry) => this.entry(entry))}
        </tbody>
      </table>
      ${shown < ael.length ? html`<p class="empty">${texts.more(ael.length - shown)}</p>` : nothing}`;
  }

  private entry({ edge, x, z, until, dx, dz }: ActiveEdge): TemplateResult {
    const before = this.old.ael.find((each) => each.edge === edge);
    const thing = edgeThing(edge);
    const pointed = thing === this.view.pointed;
    return html`<tr class=${classMap({ pointed })} data-thing=${thing}>
      <td class=${classMap({ number: true, changed: before === undefined })}>${edge}</td>
      ${numberCell(x, before?.x, this.view)} ${numberCell(z, before?.z, this.view)}
      ${numberCell(until, before?.until, this.view)} ${numberCell(dx, before?.dx, this.view)}
      ${numberCell(dz, before?.dz, this.view)}
    </tr>`;
  }
}

function edgeList(edges: readonly number[], none: string): string {
  const most = 16;
  if (edges.length === 0) return none;
  return `${edges.slice(0, most).join(' ')}${edges.length > most ? ' …' : ''}`;
}
