import { LitElement, css, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property, query } from 'lit/decorators.js';
import { base } from '../elements/theme.js';
import { texts } from '../i18n/index.js';
import type { BrokenTexts } from '../language/texts.js';
import type { Language } from '../language/language.js';
import { CellPainter, opaque } from '../picture/paint.js';
import { isPainted } from '../replay/screen.js';
import type { Pixels } from '../replay/screen.js';
import type { Trace } from '../replay/trace.js';
import type { Deviation } from '../trace/editions.js';
import { numberOf } from '../trace/events.js';
import { linesIn } from '../listing/listings.js';
import type { Comparison } from './comparison.js';
import { pictureAt } from './difference.js';
import type { Steps } from './parting.js';

/** The side of a picture, in CSS pixels. */
const side = 72;
const fault = numberOf.get('fault') ?? -1;
/** The index of a run's first fault; -1 if there is none. */
const faultIn = ({ timeline }: Trace): number => timeline.names.indexOf(fault);
/** The colour of cells that are the same in both pictures. */
const same = 0xffe6e2de;
const unpainted = 0xffffffff;

/**
 * Describes the broken line and its effect. Events: `go` with the step of the first difference, `smallest` for the smallest
 * scene that shows it, `own` to leave that scene, `back` to the right run.
 */
@customElement('vidno-broken-line')
export class BrokenLineElement extends LitElement {
  static override styles = [
    base,
    css`
      :host {
        display: flex;
        flex: none;
        flex-wrap: wrap;
        gap: 0.5rem 1.25rem;
        align-items: center;
        padding: 0.5rem 0.9rem;
        border: 1px solid var(--bad);
        border-radius: var(--radius);
        background: var(--panel);
        font-size: 0.8125rem;
      }
      .says {
        flex: 1 1 20rem;
        min-width: 0;
      }
      h2 {
        font-size: 0.9375rem;
      }
      .line {
        padding: 0 0.35em;
        border-radius: 4px;
        background: var(--bad-wash);
        color: var(--bad);
        font: 600 0.8125rem / 1.5 var(--mono);
      }
      .what {
        display: var(--what, block);
      }
      .pictures {
        display: var(--changes, flex);
        gap: 0.6rem;
      }
      canvas {
        display: block;
        border: 1px solid var(--line);
      }
      figcaption {
        color: var(--soft);
        font-size: 0.6875rem;
        text-align: center;
      }
      .ways {
        display: var(--ways, flex);
        flex-wrap: wrap;
        gap: 0.4rem;
      }
      button {
        padding: 0 0.8rem;
      }
      @media print {
        .ways {
          display: none;
        }
      }
    `,
  ];

  @property({ attribute: false }) deviation!: Deviation;
  @property({ attribute: false }) comparison!: Comparison;
  @property({ attribute: false }) language: Language = 'en';
  /** The title of the smallest scene, if it is shown. */
  @property({ attribute: false }) smallest: string | null = null;
  /** The number of differing pixels or columns at the end; null until it is known. */
  @property({ attribute: false }) atEnd: number | null = null;
  @property({ attribute: false }) text: Steps | null = null;
  @property({ type: Boolean }) complete = false;
  @query('canvas.right') private right!: HTMLCanvasElement | null;
  @query('canvas.wrong') private wrong!: HTMLCanvasElement | null;
  private painted: Comparison | null = null;

  private get say(): BrokenTexts {
    return texts[this.language].compare.broken;
  }

  override render(): TemplateResult {
    const { say, deviation, language, smallest } = this;
    const { title, says } = deviation;
    const lines = linesIn(this.comparison.one.header.method, deviation);
    return html`
      <div class="says">
        <h2>
          ${say.is('')}${lines.map((at) => html`<span class="line">${at}</span> `)}
          ${title[language]}
        </h2>
        <p class="what">${says[language]}</p>
        ${smallest === null ? nothing : html`<p><i>${say.isSmallest(smallest)}</i></p>`}
        <p class="result" role="status">${this.result()}</p>
      </div>
      ${this.hasPictures ? this.pictures() : nothing}
      <div class="ways">
        ${this.first()}
        ${
          smallest === null
            ? html`<button name="smallest" @click=${() => this.ask('smallest')}>
                ${say.smallest}
              </button>`
            : html`<button name="own" @click=${() => this.ask('own')}>${say.own}</button>`
        }
        <button name="back" @click=${() => this.ask('back')}>${say.back}</button>
      </div>
    `;
  }

  private first(): TemplateResult | typeof nothing {
    const { text, say, language } = this;
    if (text === null) return nothing;
    return html`<button name="first" @click=${() => this.ask('go', text[0])}>
      ${say.first(text[0].toLocaleString(language))}
    </button>`;
  }

  /** What the broken line leads to: a fault of the run, and a change of the picture. */
  private result(): string {
    const { say, comparison, language, complete } = this;
    const change = this.change();
    if (!complete || faultIn(comparison.one) >= 0) return change;
    const at = faultIn(comparison.other);
    return at < 0 ? change : `${say.fault((at + 1).toLocaleString(language))} ${change}`;
  }

  private change(): string {
    const { say, comparison, language, atEnd, text, complete } = this;
    if (atEnd === null) return texts[language].compare.searching;
    if (atEnd > 0) {
      const { area, curves } = comparison.one.header.scene;
      const n = atEnd.toLocaleString(language);
      if (curves !== null) return say.columns(n);
      return say.pixels(n, (area.width * area.height).toLocaleString(language));
    }
    if (text !== null) return say.stepsAlone;
    return complete ? say.nothing : texts[language].compare.searching;
  }

  private get hasPictures(): boolean {
    return this.comparison.one.header.scene.curves === null && (this.atEnd ?? 0) > 0;
  }

  private pictures(): TemplateResult {
    const { say } = this;
    const picture = (name: 'right' | 'wrong'): TemplateResult =>
      html`<figure>
        <canvas class=${name} role="img" aria-label=${say[name]}></canvas>
        <figcaption aria-hidden="true">${say[name]}</figcaption>
      </figure>`;
    return html`<div class="pictures">${picture('right')}${picture('wrong')}</div>`;
  }

  override updated(): void {
    const { comparison, right, wrong } = this;
    if (right === null || wrong === null) {
      this.painted = null;
      return;
    }
    if (this.painted === comparison) return;
    this.painted = comparison;
    const { one, other } = comparison;
    const pictures = [one, other].map((run) => pictureAt(run, run.timeline.length));
    const [rightly, wrongly] = pictures;
    if (rightly === undefined || wrongly === undefined) return;
    paintChanges(right, rightly, wrongly);
    paintChanges(wrong, wrongly, rightly);
  }

  private ask(what: 'go' | 'smallest' | 'own' | 'back', detail = 0): void {
    this.dispatchEvent(new CustomEvent<number>(what, { detail }));
  }
}

/** Paints a picture where it differs from the other one; the rest is faint. */
function paintChanges(canvas: HTMLCanvasElement, own: Pixels, other: Pixels): void {
  const { width, height } = own;
  const scale = side / Math.max(width, height);
  const ratio = devicePixelRatio;
  const [across, down] = [width, height].map((cells) => Math.max(1, Math.round(cells * scale)));
  canvas.style.width = `${across}px`;
  canvas.style.height = `${down}px`;
  canvas.width = Math.round((across ?? 1) * ratio);
  canvas.height = Math.round((down ?? 1) * ratio);
  const ink = (i: number, j: number): number => {
    const pixel = own.at(i, j);
    if (opaque(pixel) === opaque(other.at(i, j)) && isPainted(pixel) === isPainted(other.at(i, j)))
      return same;
    return isPainted(pixel) ? opaque(pixel) : unpainted;
  };
  const row = (j: number, columns: readonly number[]): ArrayLike<number> =>
    Uint32Array.from(columns, (i) => ink(i, j));
  const cells = { width, height, of: [own, other], row };
  new CellPainter().paint(canvas, cells, { x: 0, y: 0, scale: scale * ratio, ratio });
}
