import { LitElement, css, html, nothing } from 'lit';
import type { PropertyValues, TemplateResult } from 'lit';
import { customElement, property, state } from 'lit/decorators.js';
import { base } from '../../elements/theme.js';
import type { Point } from '../points.js';
import { fileOfRun, linksOf } from '../replay.js';
import type { Links, Unlinked } from '../replay.js';
import type { Shown } from '../shown.js';
import { fileOf } from '../subject.js';
import { runDetails, runName } from '../words.js';

/** The run chosen last, with links to its replay. */
@customElement('vidno-replay')
export class ReplayElement extends LitElement {
  static override styles = [
    base,
    css`
      :host {
        display: block;
        flex: none;
        min-height: 4.6em;
      }
      h2 {
        font-size: 0.8125em;
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
  /** The page of traces. */
  @property({ attribute: false }) page!: URL;
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
    if (point === null || file === null) return;
    const { setting } = point;
    const links = await linksOf(setting, fileOfRun(file, setting), page, this.shown.language);
    if (point === this.point) this.links = links;
  }

  override render(): TemplateResult {
    const { point, file } = this;
    const { texts, subjectTexts } = this.shown;
    const { title, hint } = texts.replay;
    if (point === null || file === null) {
      return html`<h2>${title}</h2>
        <p class="why">${file === null ? subjectTexts.showOne : hint}</p>`;
    }
    return html`<h2>${title}</h2>
      <p>${runName(point.setting, this.shown)} <small>${runDetails(point, this.shown)}</small></p>
      <p class="links" aria-live="polite">${this.ways()}</p>`;
  }

  private ways(): TemplateResult | typeof nothing {
    const { links } = this;
    const { replay, compare, unlinked } = this.shown.texts.replay;
    if (links === null) return nothing;
    if (typeof links === 'string') return html`<span class="why">${unlinked[links]}</span>`;
    return html`${way(links.replay, replay)}
    ${links.compare === null ? nothing : way(links.compare, compare)}`;
  }
}

const way = (href: string, label: string): TemplateResult =>
  html`<a href=${href} target="_blank" rel="noopener">${label}</a>`;
