import { LitElement, css, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { classMap } from 'lit/directives/class-map.js';
import { cornerThing, polygonThing, windowThing } from '../algorithm/pointed.js';
import { numbersOf } from '../algorithm/view.js';
import type { View } from '../algorithm/view.js';
import { chipsCell, listOf, rowsOf } from '../elements/lists.js';
import { panelsStyle } from '../elements/panels.style.js';
import { isSet, polygonName, swatch, value } from '../elements/parts.js';
import { base } from '../elements/theme.js';
import { texts } from '../i18n/index.js';
import type { FamilyTexts } from '../language/texts.js';
import type { Entry, StackedWindow, Warnock } from '../replay/values.js';
import { hasThreeLists } from '../trace/events.js';
import type { Corner } from '../trace/values.js';
import { containment } from './naming.js';
import { emptyWarnock } from './state.js';
import type { Joined } from './state.js';

/**
 * The values of a window with three lists: its level, the count of an outline so far, and the polygon that hides all
 * others.
 */
function listValues(view: View, now: Warnock, old: Warnock): readonly TemplateResult[] {
  const { header, language, texts: page } = view;
  const { family, numbers } = texts[language];
  const { panel } = family;
  const sum = now.contained.length === 0 ? page.none : numbers.short(containment(now));
  const hiding = now.covering === null ? page.none : polygonName(now.covering, view);
  const name = header.method === 'warnock-angles' ? panel.octants : panel.ray;
  return [
    value(panel.level, now.way.length, now.way.length !== old.way.length),
    value(name, sum, now.contained !== old.contained),
    value(panel.hides, hiding, now.covering !== old.covering),
  ];
}

/** The state of Warnock's algorithm: the current window, its list, its corners, and the stack. */
@customElement('vidno-warnock')
export class WarnockPanel extends LitElement {
  static override styles = [
    base,
    panelsStyle,
    css`
      :host([hall]) {
        display: grid;
        grid: auto-flow dense / minmax(0, 1fr) minmax(0, 1fr);
      }
      :host([hall]) :is(.window, .lists, .line, .window + .polygons) {
        grid-column: 1 / -1;
      }
      :host([hall]) .values .wide {
        grid-column: span 2;
      }
      :host([hall]) .corners td {
        height: 1.45rem;
        padding: 0 0.35rem;
      }
      :host([hall]) .corners small {
        display: none;
      }
      :host([hall]) .stack {
        height: auto;
        min-height: 0;
        overflow: hidden;
      }
      :host([hall]) .line {
        height: var(--row);
        align-items: center;
        white-space: nowrap;
      }
      :host([hall]) .line :is(table, td) {
        width: auto;
      }
      :host([hall]) .chips {
        display: none;
      }
    `,
  ];

  @property({ attribute: false }) view!: View;

  private get now(): Warnock {
    return this.view.after.warnock ?? emptyWarnock;
  }

  private get old(): Warnock {
    return this.view.before.warnock ?? emptyWarnock;
  }

  override render(): TemplateResult {
    const { method } = this.view.header;
    const corners = method === 'warnock-simplest' ? nothing : this.corners();
    const lists = this.areListsReported
      ? this.hasThree
        ? this.threeLists()
        : this.apl()
      : this.noLists();
    return html`${this.window()} ${corners} ${lists} ${this.stack()}`;
  }

  private get hasThree(): boolean {
    return hasThreeLists(this.view.header.method);
  }

  /** At the level of windows the trace does not say which polygons leave a list. */
  private get areListsReported(): boolean {
    return this.view.header.detail !== 'windows';
  }

  private noLists(): TemplateResult {
    const { apl, notInTrace } = this.view.texts;
    return html`<section class="polygons untold" data-part="active-polygons">
      <h3>${apl}</h3>
      <p class="empty">${notInTrace}</p>
    </section>`;
  }

  private get say(): FamilyTexts['panel'] {
    return texts[this.view.language].family.panel;
  }

  private window(): TemplateResult {
    const { now, old } = this;
    const { texts: page } = this.view;
    const { color } = now;
    return html`<section class="window" data-part="window">
      <dl class="values">
        ${value(
          page.window,
          now.window ? numbersOf(this.view).windowText(now.window) : page.none,
          now.window !== old.window,
          'wide',
        )}
        ${this.found()}
        ${value('C', color ? swatch(color) : page.none, isSet(now.color, old.color))}
        ${this.current()}
      </dl>
    </section>`;
  }

  /** The findings about the window so far. */
  private found(): readonly TemplateResult[] {
    const { now, old } = this;
    const { header, texts: page } = this.view;
    const yesNo = (flag: boolean | null): string =>
      flag === null ? page.none : flag ? page.yes : page.no;
    const k = value('k', now.k ?? page.none, isSet(now.k, old.k));
    if (header.method === 'warnock-simplest') return [];
    if (this.hasThree) return [...listValues(this.view, now, old), k];
    return [
      value('polygonCount', now.count ?? page.none, isSet(now.count, old.count)),
      value('hasSurround', yesNo(now.hasSurround), isSet(now.hasSurround, old.hasSurround)),
      value('insider', yesNo(now.insider), isSet(now.insider, old.insider)),
      k,
    ];
  }

  /** The lists of PolygonClip, or the findings of PointColor; at most one of them is in use. */
  private current(): TemplateResult {
    const { now, old } = this;
    const { texts: page } = this.view;
    if (now.clip) {
      const sizes = `${now.clip.vertices.length} → ${now.clip.next.length}`;
      return value(page.clip, sizes, now.clip !== old.clip);
    }
    const found = now.nearest;
    const shown = found
      ? html`${polygonName(found.polygon, this.view)} ${numbersOf(this.view).short(found.z)}`
      : page.none;
    return value('PointColor', shown, found !== old.nearest);
  }

  private corners(): TemplateResult {
    return html`<section class="depths" data-part="corner-depths">
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
    const changed = isSet(z ?? null, this.old.corners?.[name] ?? null);
    const thing = cornerThing(name);
    const pointed = thing === this.view.pointed;
    return html`<td
      class=${classMap({ changed, pointed })}
      data-thing=${thing}
      title=${z === undefined ? nothing : numbersOf(this.view).whole(z)}
    >
      <small>${texts[this.view.language].places[name]}</small>
      ${z === undefined ? this.view.texts.none : numbersOf(this.view).short(z)}<i>${name}</i>
    </td>`;
  }

  private apl(): TemplateResult {
    const { apl } = this.view.texts;
    const entries = this.now.apl?.entries ?? [];
    return html`<section class="polygons" data-part="active-polygons">
      <h3>${apl}</h3>
      ${listOf(apl, 'apl', entries, (entry) => this.entry(entry), this.view)}
    </section>`;
  }

  private threeLists(): TemplateResult {
    const { now, old, say } = this;
    const joined = (name: keyof Warnock['joined']): TemplateResult => {
      const list = [...now.joined[name]].reverse();
      const fresh = list.length > old.joined[name].length ? list[0] : undefined;
      return html`<div>
        <h4>${say[name]}</h4>
        ${listOf(say[name], 'apl', list, (each) => this.joinedEntry(each, each === fresh), this.view)}
      </div>`;
    };
    return html`<section class="lists" data-part="active-polygons">
      <div>
        <h4>${say.third}</h4>
        ${listOf(say.third, 'apl', now.apl?.entries ?? [], (entry) => this.entry(entry), this.view)}
      </div>
      ${joined('surrounding')} ${joined('outside')}
    </section>`;
  }

  private entry([id, surrounds]: Entry): TemplateResult {
    const before = this.old.apl?.entries.find(([other]) => other === id);
    const { event, texts: page } = this.view;
    const current = event !== null && 'polygon' in event && event.polygon === id;
    const changed = before !== undefined && before[1] !== surrounds;
    const thing = polygonThing(id);
    const pointed = thing === this.view.pointed;
    return html`<tr class=${classMap({ current: current, pointed })} data-thing=${thing}>
      <td>${polygonName(id, this.view)}</td>
      <td class=${classMap({ changed })}>${surrounds ? page.surrounds : ''}</td>
    </tr>`;
  }

  /** A polygon that has the relation to all parts of a window, and the level of that window. */
  private joinedEntry({ polygon, level }: Joined[number], changed: boolean): TemplateResult {
    const { event } = this.view;
    const current = event !== null && 'polygon' in event && event.polygon === polygon;
    const thing = polygonThing(polygon);
    const pointed = thing === this.view.pointed;
    return html`<tr class=${classMap({ current, pointed })} data-thing=${thing}>
      <td>${polygonName(polygon, this.view)}</td>
      <td class=${classMap({ changed, level: true })} title=${this.say.sinceLevel(level)}>
        ${level}
      </td>
    </tr>`;
  }

  private stack(): TemplateResult {
    const { stack } = this.now;
    const fresh = stack.length > this.old.stack.length;
    const shown = [...stack].reverse();
    const row = (each: StackedWindow, i: number): TemplateResult =>
      this.stacked(each, i === 0 && fresh);
    // In a hall the stack is beside the corners, or in a line below them if a list is there.
    return html`<section class="stack ${this.hasThree ? '' : 'line'}" data-part="stack">
      <h3>${this.view.texts.stack}</h3>
      ${rowsOf(shown, row, this.view, 'windows', this.hasThree ? 2 : 1)}
    </section>`;
  }

  private stacked({ window, apl }: StackedWindow, changed: boolean): TemplateResult {
    const { entries } = apl;
    const thing = windowThing(window);
    const pointed = thing === this.view.pointed;
    const ids = entries.map(([id]) => id);
    return html`<tr class=${classMap({ pointed })} data-thing=${thing}>
      <td class=${classMap({ number: true, changed })}>
        ${numbersOf(this.view).windowText(window)}
      </td>
      ${
        this.areListsReported
          ? html`<td class="number">${entries.length}</td>
              ${chipsCell(ids, this.view)}`
          : nothing
      }
    </tr>`;
  }
}
