import { LitElement, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { classMap } from 'lit/directives/class-map.js';
import { short, windowText } from '../i18n/words.js';
import { texts } from '../i18n/index.js';
import { cornerThing, polygonThing, windowThing } from '../pointed.js';
import { emptyWarnock } from '../state/warnock.js';
import type { Entry, StackedWindow, Warnock } from '../state/warnock.js';
import type { Corner } from '../trace/values.js';
import type { View } from '../view.js';
import { panelsStyle } from './panels.style.js';
import { polygonName, swatch, value } from './parts.js';
import { base } from './theme.js';

const mostRows = 200;
const chips = 12;

/** The state of Warnock's algorithm: the window in hand, its list, its corners, and the stack. */
@customElement('vidno-warnock')
export class WarnockPanel extends LitElement {
  static override styles = [base, panelsStyle];

  @property({ attribute: false }) view!: View;

  private get now(): Warnock {
    return this.view.after.warnock ?? emptyWarnock;
  }

  private get old(): Warnock {
    return this.view.before.warnock ?? emptyWarnock;
  }

  override render(): TemplateResult {
    return html` ${this.window()} ${this.corners()} ${this.apl()} ${this.stack()} `;
  }

  private window(): TemplateResult {
    const { now, old } = this;
    const { texts: page } = this.view;
    const yesNo = (flag: boolean): string => (flag ? page.yes : page.no);
    return html`<section>
      <dl class="values">
        ${value(
          page.window,
          now.window ? windowText(now.window) : page.none,
          now.window !== old.window,
          'wide',
        )}
        ${value('polygonCount', now.count, now.count !== old.count)}
        ${value('hasSurround', yesNo(now.hasSurround), now.hasSurround !== old.hasSurround)}
        ${value('insider', yesNo(now.insider), now.insider !== old.insider)}
        ${value('k', now.k ?? page.none, now.k !== old.k)}
        ${value('C', now.color ? swatch(now.color) : page.none, now.color !== old.color)}
        ${this.inHand()}
      </dl>
    </section>`;
  }

  /** The lists of PolygonClip or what PointColor found: one of them, or neither, is in play. */
  private inHand(): TemplateResult {
    const { now, old } = this;
    const { texts: page } = this.view;
    if (now.clip) {
      const sizes = `${now.clip.vertices.length} → ${now.clip.next.length}`;
      return value(page.clip, sizes, now.clip !== old.clip);
    }
    const found = now.nearest;
    const shown = found
      ? html`${polygonName(found.polygon, this.view)} ${short(found.z)}`
      : page.none;
    return value('PointColor', shown, found !== old.nearest);
  }

  private corners(): TemplateResult {
    return html`<section>
      <h3>${this.view.texts.cornerDepths}</h3>
      <table class="corners">
        <tbody>
          <tr>
            ${this.corner('lb')} ${this.corner('rb')}
          </tr>
          <tr>
            ${this.corner('lt')} ${this.corner('rt')}
          </tr>
        </tbody>
      </table>
    </section>`;
  }

  private corner(name: Corner): TemplateResult {
    const z = this.now.corners?.[name];
    const changed = z !== this.old.corners?.[name];
    const thing = cornerThing(name);
    const pointed = thing === this.view.pointed;
    return html`<td
      class=${classMap({ changed, pointed })}
      data-thing=${thing}
      title=${z === undefined ? nothing : String(z)}
    >
      <small>${texts[this.view.language].places[name]}</small>
      ${z === undefined ? this.view.texts.none : short(z)}<i>${name}</i>
    </td>`;
  }

  private apl(): TemplateResult {
    const entries = this.now.apl?.entries ?? [];
    return html`<section>
      <h3>${this.view.texts.apl}</h3>
      <div class="list apl" tabindex="0" role="region" aria-label=${this.view.texts.apl}>
        <table class="rows">
          <tbody>
            ${entries.slice(0, mostRows).map((entry) => this.entry(entry))}
          </tbody>
        </table>
        ${this.emptyOrMore(entries.length)}
      </div>
    </section>`;
  }

  private entry([id, surrounds]: Entry): TemplateResult {
    const before = this.old.apl?.entries.find(([other]) => other === id);
    const { event, texts: page } = this.view;
    const inHand = event !== null && 'polygon' in event && event.polygon === id;
    const changed = before !== undefined && before[1] !== surrounds;
    const thing = polygonThing(id);
    const pointed = thing === this.view.pointed;
    return html`<tr class=${classMap({ current: inHand, pointed })} data-thing=${thing}>
      <td>${polygonName(id, this.view)}</td>
      <td class=${classMap({ changed })}>${surrounds ? page.surrounds : ''}</td>
    </tr>`;
  }

  private stack(): TemplateResult {
    const { stack } = this.now;
    const fresh = stack.length > this.old.stack.length;
    const shown = [...stack].reverse().slice(0, mostRows);
    return html`<section class="stack">
      <h3>${this.view.texts.stack}</h3>
      <table class="rows windows">
        <tbody>
          ${shown.map((each, i) => this.stacked(each, i === 0 && fresh))}
        </tbody>
      </table>
      ${this.emptyOrMore(stack.length)}
    </section>`;
  }

  private stacked({ window, apl }: StackedWindow, changed: boolean): TemplateResult {
    const { entries } = apl;
    const thing = windowThing(window);
    const pointed = thing === this.view.pointed;
    return html`<tr class=${classMap({ pointed })} data-thing=${thing}>
      <td class=${classMap({ number: true, changed })}>${windowText(window)}</td>
      <td class="number">${entries.length}</td>
      <td class="chips">
        ${entries
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
