import { LitElement, css, html, svg } from 'lit';
import type { SVGTemplateResult, TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { showsOf } from '../algorithm/shows.js';
import type { View } from '../algorithm/view.js';
import { base } from '../elements/theme.js';
import type { LegendEntry } from '../language/picture-texts.js';
import { curvesStyle } from './curves.style.js';
import { marksStyle } from './marks.style.js';
import { regionsStyle } from './regions.style.js';

const dots: readonly LegendEntry[] = ['yes', 'no', 'edge'];

/** What the marks on the picture mean; in its slot, what can be done with the picture. */
@customElement('vidno-legend')
export class LegendElement extends LitElement {
  static override styles = [
    base,
    marksStyle,
    curvesStyle,
    regionsStyle,
    css`
      ul {
        display: flex;
        flex-wrap: wrap;
        gap: 0.1rem 0.9rem;
        padding: 0 0.75rem 0.4rem;
        list-style: none;
        font-size: 0.75rem;
        color: var(--soft);
      }
      li {
        display: flex;
        gap: 0.35rem;
        align-items: center;
        white-space: nowrap;
      }
      .more {
        margin-left: auto;
      }
      svg {
        width: 1.25rem;
        height: 0.875rem;
        background: #ffffff;
        border-radius: 2px;
      }
    `,
  ];

  @property({ attribute: false }) view!: View;

  override render(): TemplateResult {
    const { texts } = this.view;
    const { legend, icon } = showsOf(this.view);
    return html`<ul>
      ${legend.map(
        (entry) =>
          html`<li>
            <svg viewBox="0 0 20 14" aria-hidden="true">${icon?.(entry) ?? plainIcon(entry)}</svg
            >${texts.legend[entry]}
          </li>`,
      )}
      <li class="more"><slot></slot></li>
    </ul>`;
  }
}

function plainIcon(entry: LegendEntry): SVGTemplateResult {
  if (entry === 'chosen') {
    return svg`<path class="chosen" d="M6 3.5h8v7h-8ZM10 1v2.5M10 10.5v2.5M3 7h3M14 7h3" />`;
  }
  if (dots.includes(entry)) return svg`<circle class="dot ${entry}" cx="10" cy="7" r="4.5" />`;
  if (entry === 'tree') {
    return svg`<path class="tree" d="M2.5 1.5h15v11h-15ZM10 1.5v11M2.5 7h15M6.25 7v5.5M2.5 9.75h7.5" />`;
  }
  if (entry !== 'active') return svg`<rect class=${entry} x="3" y="3" width="14" height="8" />`;
  return svg`<path class="casing active" d="M3 11L17 3" />
    <path class="active" d="M3 11L17 3" stroke="#d08a00" />`;
}
