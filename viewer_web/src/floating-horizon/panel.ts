import { LitElement, css, html } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { classMap } from 'lit/directives/class-map.js';
import type { FloatingHorizon } from '../replay/values.js';
import { flagLooks } from './shapes.js';
import { emptyFloatingHorizon } from './state.js';
import type { Flag, Looked } from './state.js';
import { texts } from '../i18n/index.js';
import type { CurveTexts } from '../language/texts.js';
import { columnThing, curveThing } from '../algorithm/pointed.js';
import type { N, Sample } from '../trace/values.js';
import { numbersOf } from '../algorithm/view.js';
import type { View } from '../algorithm/view.js';
import { panelsStyle } from '../elements/panels.style.js';
import { value } from '../elements/parts.js';
import { base } from '../elements/theme.js';

const columnsShown = 9;
const columnsInHall = 5;

const horizonPanelStyle = css`
  .values.two {
    grid-template-columns: minmax(0, 1fr) minmax(0, 1fr);
  }
  .rows {
    table-layout: fixed;
  }
  .rows th:first-child {
    width: 3.8rem;
  }
  .rows th:nth-child(2) {
    width: 5.2rem;
  }
  .rows th[scope='row'] {
    font-size: 0.8125rem;
  }
  .rows td {
    overflow: hidden;
    font-size: 0.8125rem;
    text-overflow: ellipsis;
  }
  .rows tr.current :is(th, td) {
    font-weight: 700;
  }
  :host([hall]) .values.two {
    grid-template-columns: repeat(6, minmax(0, 1fr));
  }
  :host([hall]) .two div {
    grid-column: span 2;
  }
  /* The columns after the number of lines, since they need more room. */
  :host([hall]) .two div:is(:nth-child(3), :nth-child(4)) {
    grid-column: span 3;
    order: 1;
  }
  :host([hall]) .list {
    --heads: 3; /* a line for the heads, and two more columns */
  }
`;

/** The state of the floating horizon: curve, segment, side edges, the last two columns, the horizons around them. */
@customElement('vidno-horizon')
export class HorizonPanel extends LitElement {
  static override styles = [base, panelsStyle, horizonPanelStyle];

  @property({ attribute: false }) view!: View;

  private get say(): CurveTexts {
    return texts[this.view.language].curves;
  }

  private get now(): FloatingHorizon {
    return this.view.after.floatingHorizon ?? emptyFloatingHorizon;
  }

  private get old(): FloatingHorizon {
    return this.view.before.floatingHorizon ?? emptyFloatingHorizon;
  }

  override render(): TemplateResult {
    const { say } = this;
    return html`
      ${this.place()}
      <section class="line" data-part="side-edges">
        <h3>${say.edges}</h3>
        <dl class="values two">
          ${this.edge(say.left, this.now.edges.left, this.old.edges.left)}
          ${this.edge(say.right, this.now.edges.right, this.old.edges.right)}
        </dl>
      </section>
      <section data-part="horizons">
        <h3>${say.around(numbersOf(this.view).short(this.column))}</h3>
        <div
          class="list"
          tabindex="0"
          role="region"
          aria-label=${say.around(numbersOf(this.view).short(this.column))}
        >
          ${this.horizons()}
        </div>
      </section>
    `;
  }

  private place(): TemplateResult {
    const { now, old, say } = this;
    const { texts: page, before, lines } = this.view;
    const segment = now.place.segment?.join(' … ') ?? page.none;
    const curve =
      now.curve === null
        ? page.none
        : html`<span data-thing=${curveThing(now.curve)}>${now.curve}</span>`;
    return html`<section data-part="curve">
      <dl class="values two">
        ${value(say.current, curve, now.curve !== old.curve)}
        ${value(say.segment, segment, now.place.segment?.join() !== old.place.segment?.join())}
        ${value('x, Pflag', this.looked(now.place.previous), isOther(now, old, 'previous'))}
        ${value('x′, Tflag', this.looked(now.place.current), isOther(now, old, 'current'))}
        ${value(say.lines, lines.length, lines.length !== before.lines?.length)}
      </dl>
    </section>`;
  }

  private looked(at: Looked | null): unknown {
    if (at === null) return this.view.texts.none;
    const [x, flag] = at;
    return html`<span data-thing=${columnThing(x)}>${x}</span> · ${this.say.flags[flagLooks[flag]]}`;
  }

  private edge(name: string, now: Sample | null, old: Sample | null): TemplateResult {
    return value(
      name,
      now === null ? this.view.texts.none : numbersOf(this.view).point(now),
      now !== old,
    );
  }

  /** The column of the step, or the one examined last. */
  private get column(): number {
    const { event, header } = this.view;
    const { area } = header.scene;
    const { current, previous } = this.now.place;
    if (event !== null && 'x' in event && event.e !== 'fault' && typeof event.x === 'number')
      return event.x;
    if (event?.e === 'horizon' && event.first <= event.last) return event.first;
    return current?.[0] ?? previous?.[0] ?? area.x;
  }

  /** The horizons over a constant number of columns, so that nothing moves. */
  private horizons(): TemplateResult {
    const { columns, header, texts: page, hall } = this.view;
    const { area } = header.scene;
    if (columns === null || header.detail === 'windows') {
      return html`<p class="hint">${page.notInTrace}</p>`;
    }
    const count = Math.min(hall === true ? columnsInHall : columnsShown, area.width);
    const middle = this.column - Math.floor(count / 2);
    const first = Math.min(Math.max(middle, area.x), area.x + area.width - count);
    const { say } = this;
    return html`<table class="rows">
      <thead>
        <tr>
          <th scope="col">${say.column}</th>
          <th scope="col">${say.looked}</th>
          <th scope="col">${say.upper}</th>
          <th scope="col">${say.lower}</th>
        </tr>
      </thead>
      <tbody>
        ${Array.from({ length: count }, (_, i) => this.row(first + i))}
      </tbody>
    </table>`;
  }

  private row(x: number): TemplateResult {
    const { columns, header, event, pointed } = this.view;
    const i = x - header.scene.area.x;
    const flag = columns?.flags[i] ?? null;
    const thing = columnThing(x);
    const isFlagged = event?.e === 'visibility' && event.x === x;
    const classes = { current: x === this.column, pointed: pointed === thing };
    return html`<tr class=${classMap(classes)} data-thing=${thing}>
      <th scope="row" class="number">${numbersOf(this.view).short(x)}</th>
      <td class=${classMap({ changed: isFlagged })}>${this.flag(flag)}</td>
      ${this.height('upper', i, x)} ${this.height('lower', i, x)}
    </tr>`;
  }

  private flag(flag: Flag | null): string {
    return flag === null ? this.view.texts.none : this.say.flags[flagLooks[flag]];
  }

  private height(which: 'upper' | 'lower', i: number, x: number): TemplateResult {
    const { columns, event, texts: page } = this.view;
    const height: N | null = columns?.horizons[which][i] ?? null;
    const { short, whole } = numbersOf(this.view);
    const one = which === 'upper' ? 'raise' : 'lower';
    const changed =
      event?.e === 'horizon'
        ? event[which].some(([column]) => column === x)
        : event?.e === one && event.x === x;
    return html`<td
      class=${classMap({ number: true, changed })}
      title=${height === null ? '' : whole(height)}
    >
      ${height === null ? page.none : short(height)}
    </td>`;
  }
}

function isOther(
  now: FloatingHorizon,
  old: FloatingHorizon,
  which: 'previous' | 'current',
): boolean {
  return now.place[which]?.join() !== old.place[which]?.join();
}
