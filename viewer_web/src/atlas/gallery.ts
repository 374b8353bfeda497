import { LitElement, css, html, nothing, svg } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property, query, state } from 'lit/decorators.js';
import { base, dialogStyle } from '../elements/theme.js';
import { texts } from '../i18n/index.js';
import type { AtlasTexts, FailureKind } from '../language/texts.js';
import { editionName } from '../language/family.js';
import type { Language } from '../language/language.js';
import { drawn } from '../picture/drawn.js';
import { embeddedAtlas, entryKinds } from './entries.js';
import type { Entry } from './entries.js';
import { Pictures } from './pictures.js';
import type { Thumbnail } from './pictures.js';

const galleryStyle = css`
  :host {
    display: contents;
  }
  dialog {
    width: min(72rem, calc(100vw - 2rem));
    max-width: none;
    height: calc(100dvh - 3rem);
    padding: 0;
    overflow: hidden;
  }
  dialog[open] {
    display: flex;
    flex-direction: column;
  }
  .head {
    display: flex;
    flex: none;
    flex-wrap: wrap;
    gap: 0.5rem 1rem;
    align-items: center;
    padding: 0.75rem 1rem;
    border-bottom: 1px solid var(--line);
  }
  h2 {
    flex: 1;
    margin: 0;
    white-space: nowrap;
  }
  label {
    color: var(--soft);
    font-size: 0.8125rem;
  }
  select {
    max-width: 100%;
    margin-left: 0.3rem;
  }
  .close {
    padding: 0 0.8rem;
  }
  ul {
    display: grid;
    grid-template-columns: repeat(auto-fill, minmax(min(13rem, 100%), 1fr));
    gap: 0.75rem;
    margin: 0;
    padding: 1rem;
    overflow: auto;
    list-style: none;
  }
  .entry {
    display: flex;
    flex-direction: column;
    gap: 0.2rem;
    width: 100%;
    height: 100%;
    padding: 0.6rem;
    border: 1px solid var(--line);
    border-radius: var(--radius);
    background: none;
    color: inherit;
    font: inherit;
    text-align: left;
    white-space: normal;
  }
  button.entry:hover {
    border-color: var(--accent);
    background: var(--accent-wash);
  }
  .picture {
    display: flex;
    align-items: center;
    justify-content: center;
    height: 8rem;
    margin-bottom: 0.3rem;
    border-radius: 4px;
    background: var(--paper);
    color: var(--soft);
    font-size: 0.75rem;
  }
  svg {
    width: 100%;
    height: 100%;
  }
  path {
    fill: none;
    vector-effect: non-scaling-stroke;
  }
  .patch {
    shape-rendering: crispedges;
  }
  .outline {
    stroke-width: 1.5;
    stroke-opacity: 0.8;
  }
  .line {
    stroke: var(--ink);
    stroke-width: 1.5;
  }
  .wrong {
    stroke: var(--bad);
    stroke-width: 3;
  }
  strong {
    font-size: 0.875rem;
    font-weight: 600;
  }
  small {
    color: var(--soft);
    font-size: 0.75rem;
  }
  .why {
    display: -webkit-box;
    overflow: hidden;
    color: var(--soft);
    font-size: 0.75rem;
    -webkit-box-orient: vertical;
    -webkit-line-clamp: 2;
  }
`;

/** The atlas of failures as a dialog of pictures. An event `choose` names the entry to open. */
@customElement('vidno-gallery')
export class GalleryElement extends LitElement {
  static override styles = [base, dialogStyle, galleryStyle];

  @property({ attribute: false }) language: Language = 'en';
  /** The library that draws the pictures. Without it there are no pictures, and no run can be opened. */
  @property({ attribute: false }) library: Blob | null = null;
  @state() private entries: readonly Entry[] = [];
  @state() private kind: FailureKind | null = null;
  @state() private pictures: ReadonlyMap<string, Thumbnail> = new Map();
  @query('dialog') private dialog!: HTMLDialogElement;
  @query('#title') private heading!: HTMLElement;
  private drawing = false;

  get open(): boolean {
    return this.dialog.open;
  }

  async show(): Promise<void> {
    if (this.entries.length === 0) this.entries = await embeddedAtlas(document);
    await this.updateComplete;
    if (!this.dialog.open) this.dialog.showModal();
    this.heading.focus();
    if (!this.drawing) await this.draw();
  }

  /** Draws the pictures one after the other, in the order of the entries. */
  private async draw(): Promise<void> {
    const { library } = this;
    if (library === null) return;
    this.drawing = true;
    const pictures = new Pictures(library);
    for (const entry of this.entries) {
      const picture = await pictures.of(entry);
      if (picture !== null) this.pictures = new Map(this.pictures).set(entry.name, picture);
    }
  }

  override render(): TemplateResult {
    const { entries, kind, language } = this;
    const say = texts[language].atlas;
    const shown = entries.filter((entry) => kind === null || entry.kind === kind);
    return html`<dialog aria-labelledby="title">
      <div class="head">
        <h2 id="title" tabindex="-1">${say.title}</h2>
        ${this.filter(say)}
        <button class="close" @click=${() => this.dialog.close()}>${say.close}</button>
      </div>
      <ul>
        ${shown.map((entry) => this.entry(entry, say))}
      </ul>
    </dialog>`;
  }

  private filter(say: AtlasTexts): TemplateResult {
    const { entries } = this;
    const count = (kind: FailureKind | null): number =>
      entries.filter((entry) => kind === null || entry.kind === kind).length;
    return html`<label>
      ${say.show}
      <select
        name="kind"
        @change=${({ target }: Event) => {
          const { value } = target as HTMLSelectElement;
          this.kind = entryKinds.find((each) => each === value) ?? null;
        }}
      >
        <option value="">${say.all} (${count(null)})</option>
        ${entryKinds.map(
          (each) => html`<option value=${each}>${say.kinds[each]} (${count(each)})</option>`,
        )}
      </select>
    </label>`;
  }

  private entry(entry: Entry, say: AtlasTexts): TemplateResult {
    const { language } = this;
    const { name, title, why, fails, kind } = entry;
    const content = html`${this.picture(entry, say)}
      <strong>${title[language]}</strong>
      <small>${fails === undefined ? say.kinds[kind] : this.runOf(fails)}</small>
      <span class="why" title=${why[language]}>${why[language]}</span>`;
    return html`<li>
      ${
        fails === undefined || this.library === null
          ? html`<div class="entry">${content}</div>`
          : html`<button
              class="entry"
              data-entry=${name}
              @click=${() => {
                this.dialog.close();
                this.dispatchEvent(new CustomEvent<Entry>('choose', { detail: entry }));
              }}
            >
              ${content}
            </button>`
      }
    </li>`;
  }

  private runOf({ method, kernel, edition }: NonNullable<Entry['fails']>): string {
    const { page } = texts[this.language];
    const text = edition === 'corrected' ? [] : [editionName(page.editions, edition)];
    return [page.methods[method], kernel, ...text].join(' · ');
  }

  private picture({ name, fails }: Entry, say: AtlasTexts): TemplateResult {
    const picture = this.pictures.get(name);
    if (picture === undefined) {
      return html`<div class="picture">${fails === undefined ? say.noScene : nothing}</div>`;
    }
    return html`<div class="picture">
      <svg viewBox=${picture.shown.join(' ')} aria-hidden="true">
        ${picture.shapes.map((shape) => svg`${drawn(shape)}`)}
      </svg>
    </div>`;
  }
}
