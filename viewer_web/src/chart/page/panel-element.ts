import { LitElement, css, html, nothing, svg } from 'lit';
import type { PropertyValues, SVGTemplateResult, TemplateResult } from 'lit';
import { customElement, property, state } from 'lit/decorators.js';
import { base } from '../../elements/theme.js';
import { pairOf } from '../pictures.js';
import type { Pair, Shot } from '../pictures.js';
import type { Point } from '../points.js';
import { fileOfRun, linksOf } from '../replay.js';
import type { Links, Unlinked } from '../replay.js';
import type { Shown } from '../shown.js';
import { fileOf } from '../subject.js';
import { axesOf } from '../subject.js';
import { costAmount, errorAmount, inLine, runDetails, runName } from '../words.js';

/** The run chosen last: its picture beside the right one, and links to its replay. */
@customElement('vidno-panel')
export class PanelElement extends LitElement {
  static override styles = [
    base,
    css`
      :host {
        display: block;
        flex: none;
      }
      h2 {
        font-size: 0.8125em;
      }
      .pictures {
        display: grid;
        grid-template-columns: 1fr 1fr;
        gap: 0.6em;
        margin-top: 0.4em;
      }
      .pictures svg {
        display: block;
        width: 100%;
        max-height: 16rem;
        border: 1px solid var(--line);
        background: #ffffff;
      }
      figcaption {
        font-size: 0.8125em;
        color: var(--soft);
      }
      .wrong {
        fill: none;
        stroke: #a3122b;
        stroke-width: 2;
        vector-effect: non-scaling-stroke;
      }
      .lines {
        fill: none;
        stroke: #171b24;
        stroke-width: 1.25;
        vector-effect: non-scaling-stroke;
      }
      .links {
        display: flex;
        flex-wrap: wrap;
        gap: 0.2em 1.2em;
        margin-top: 0.2em;
      }
      a {
        color: var(--accent);
      }
      .why,
      small {
        color: var(--soft);
      }
    `,
  ];

  @property({ attribute: false }) shown!: Shown;
  @property({ attribute: false }) point: Point | null = null;
  /** The page of traces, if it is known. */
  @property({ attribute: false }) page: URL | null = null;
  @state() private links: Links | Unlinked | null = null;

  override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has('point') || changed.has('shown')) void this.find();
  }

  /** The file of the subject, if a single one is shown. */
  private get file(): object | null {
    const { name, subjects } = this.shown.view;
    const [only] = subjects;
    return (name === null || only === undefined ? null : fileOf(only)) ?? null;
  }

  private async find(): Promise<void> {
    const { point, page, file } = this;
    this.links = null;
    if (point === null || file === null || page === null) return;
    const { setting } = point;
    const links = await linksOf(setting, fileOfRun(file, setting), page, this.shown.language);
    if (point === this.point) this.links = links;
  }

  override render(): TemplateResult {
    const { point, shown } = this;
    const { texts, subjectTexts, view } = shown;
    const { title, hint } = texts.panel;
    if (point === null || view.name === null) {
      return html`<h2>${title}</h2>
        <p class="why">${view.name === null ? subjectTexts.showOne : hint}</p>`;
    }
    const [error] = axesOf(view.subjects).errors;
    const [cost, wrong] = [costAmount(point, shown), errorAmount(point, { ...shown, error })];
    const details = runDetails(point, shown);
    return html`<h2>${title}</h2>
      <p>
        ${runName(point.setting, shown)}
        ${details === '' ? nothing : html`<small>${details}</small>`}
      </p>
      <p>
        <small>
          ${texts.costs[shown.cost].name}: ${inLine(cost)}; ${texts.errors[error].name}:
          ${inLine(wrong)}
        </small>
      </p>
      ${this.pictures(point)}
      <p class="links" aria-live="polite">${this.ways()}</p>`;
  }

  private pictures({ run }: Point): TemplateResult | typeof nothing {
    const { view, texts } = this.shown;
    const [subject] = view.subjects;
    const pair = run === null || subject === undefined ? null : pairOf(subject, run);
    if (pair === null) return nothing;
    const { own, right } = texts.panel;
    return html`<div class="pictures">
      <figure>
        ${drawing(pair.own, own, pair.wrong)}
        <figcaption>${own}</figcaption>
      </figure>
      <figure>
        ${drawing(pair.right, right)}
        <figcaption>${right}</figcaption>
      </figure>
    </div>`;
  }

  private ways(): TemplateResult | typeof nothing {
    const { links } = this;
    const { replay, compare, unlinked } = this.shown.texts.panel;
    if (links === null) return nothing;
    if (typeof links === 'string') return html`<span class="why">${unlinked[links]}</span>`;
    return html`${way(links.replay, replay)}
    ${links.compare === null ? nothing : way(links.compare, compare)}`;
  }
}

/** A picture; the pixels that are wrong in it have an outline. */
function drawing(
  { width, height, strips, lines }: Shot,
  name: string,
  wrong: Pair['wrong'] = [],
): TemplateResult {
  const pixels = strips.map(
    ({ x, y, width: across, color }) =>
      svg`<rect x=${x} y=${y} width=${across} height="1" fill=${color} />`,
  );
  const outline = wrong.map(({ x, y, width: across }) => `M${x} ${y}h${across}v1h${-across}z`);
  return html`<svg
    viewBox=${`0 0 ${width} ${height}`}
    role="img"
    aria-label=${name}
    shape-rendering=${lines.length > 0 ? 'auto' : 'crispEdges'}
  >
    ${pixels}${outline.length === 0 ? nothing : svg`<path class="wrong" d=${outline.join('')} />`}
    ${lines.map((line): SVGTemplateResult => svg`<path class="lines" d=${`M${line.join('L')}`} />`)}
  </svg>`;
}

const way = (href: string, label: string): TemplateResult =>
  html`<a href=${href} target="_blank" rel="noopener">${label}</a>`;
