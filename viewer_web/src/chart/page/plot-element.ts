import { LitElement, css, html } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property, query } from 'lit/decorators.js';
import { base } from '../../elements/theme.js';
import { OwnSize } from '../../picture/own-size.js';
import { byCost, byError } from '../points.js';
import { layoutOf } from '../layout.js';
import { drawPlot } from '../plot.js';
import type { Point } from '../points.js';
import type { Shown } from '../shown.js';
import { pointLines } from '../words.js';
import { colors } from './colors.style.js';

/** The plot on paper: 8 cm wide, as a column of a paper, with letters of 7 points. */
const column = { width: (8 / 2.54) * 96, height: (8 / 2.54) * 96, font: (7 / 72) * 96 };

/** The plot, with keyboard navigation through its points. */
@customElement('vidno-plot')
export class PlotElement extends LitElement {
  static override styles = [
    base,
    colors,
    css`
      :host {
        display: block;
        position: relative;
      }
      .canvas {
        position: absolute;
        inset: 0;
        overflow: hidden;
        border-radius: var(--radius);
      }
      .canvas svg {
        --plot-background: var(--panel);
        display: block;
      }
      text,
      tspan {
        white-space: pre;
      }
      .printed {
        display: none;
        width: 8cm;
      }
      .printed svg {
        --plot-background: var(--panel);
        display: block;
        width: 100%;
        height: auto;
      }
      @media print {
        .canvas {
          display: none;
        }
        .printed {
          --line: #d8d8d8;
          display: block;
        }
      }
      .said {
        position: absolute;
        clip-path: inset(50%);
        width: 1px;
        height: 1px;
        overflow: hidden;
      }
    `,
  ];

  @property({ attribute: false }) shown!: Shown;
  @property({ attribute: false }) chosen: Point | null = null;
  @query('.canvas') private canvas!: HTMLElement;
  @query('.printed') private printed!: HTMLElement;

  private readonly size = new OwnSize(this);

  override updated(): void {
    const { width, height } = this.size.value;
    if (width === 0) return;
    const { shown, chosen, canvas } = this;
    const screen = layoutOf(shown, width, height);
    canvas.replaceChildren(drawPlot(shown, screen, { chosen, inInk: false }));
    const paper = layoutOf(shown, column.width, column.height, column.font);
    this.printed.replaceChildren(drawPlot(shown, paper, { chosen: null, inInk: true }));
  }

  override render(): TemplateResult {
    const { texts, cost, error } = this.shown;
    const said = this.chosen === null ? '' : pointLines(this.chosen, this.shown).join('; ');
    return html`
      <div
        class="canvas"
        tabindex="0"
        role="application"
        aria-label=${texts.plot(texts.costs[cost].name, texts.errors[error].name)}
        aria-describedby="keys"
        @keydown=${this.onKey}
        @pointermove=${() => this.choose(null)}
        @click=${this.onClick}
      ></div>
      <div class="printed"></div>
      <p class="said" id="keys">${texts.keys}</p>
      <p class="said" aria-live="polite">${said}</p>
    `;
  }

  /** The plot's value is the point under the mouse. */
  private onClick(): void {
    const plot = this.canvas.firstElementChild as { readonly value?: Point | null } | null;
    if (plot?.value) this.choose(plot.value);
  }

  private onKey(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const act = this.actionOf(event.key);
    if (act === null) return;
    event.preventDefault();
    act();
  }

  private actionOf(key: string): (() => void) | null {
    const actions: Readonly<Record<string, () => void>> = {
      ArrowRight: () => this.move(byCost, 1),
      ArrowLeft: () => this.move(byCost, -1),
      ArrowUp: () => this.move(byError, 1),
      ArrowDown: () => this.move(byError, -1),
      Home: () => this.choose(this.sorted(byCost)[0] ?? null),
      End: () => this.choose(this.sorted(byCost).at(-1) ?? null),
      Escape: () => this.choose(null),
    };
    return actions[key] ?? null;
  }

  private sorted(order: typeof byCost): readonly Point[] {
    return [...this.shown.visible].sort(order);
  }

  private move(order: typeof byCost, by: 1 | -1): void {
    const points = this.sorted(order);
    const at = this.chosen === null ? -1 : points.indexOf(this.chosen);
    const next = at < 0 ? (by > 0 ? 0 : points.length - 1) : at + by;
    this.choose(points[next] ?? this.chosen);
  }

  private choose(point: Point | null): void {
    if (point !== this.chosen) this.dispatchEvent(new CustomEvent('point', { detail: point }));
  }
}
