import { LitElement, css, html } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property, query, state } from 'lit/decorators.js';
import type { FileTexts } from '../language/texts.js';
import { base } from './theme.js';

/** Accepts files of the reader's own, chosen or dropped anywhere on the page: an event `files`. */
@customElement('vidno-file-drop')
export class FileDropElement extends LitElement {
  static override styles = [
    base,
    css`
      :host {
        display: block;
        padding: 0.7rem 0.9rem;
        border: 1.5px dashed var(--line);
        border-radius: var(--radius);
        background: var(--panel);
        text-align: center;
      }
      :host([over]) {
        border-color: var(--accent);
        background: var(--accent-wash);
      }
      :host([compact]) {
        padding: 0;
        border: 0;
        background: none;
      }
      :host([compact]) :is(h2, p) {
        display: none;
      }
      h2 {
        margin-bottom: 0.4rem;
      }
      button {
        padding: 0 0.9rem;
      }
      p {
        margin-top: 0.3rem;
        font-size: 0.75rem;
        color: var(--soft);
      }
      input {
        display: none;
      }
    `,
  ];

  @property({ attribute: false }) texts!: FileTexts;
  @property() accept = '.jsonl,.gz,.json,.obj,.mtl,.off,.ply,.stl';
  @property({ type: Boolean, reflect: true }) over = false;
  @state() private depth = 0;
  @query('input') private input!: HTMLInputElement;

  override connectedCallback(): void {
    super.connectedCallback();
    for (const [name, listener] of this.listeners) window.addEventListener(name, listener);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    for (const [name, listener] of this.listeners) window.removeEventListener(name, listener);
  }

  private readonly listeners = [
    ['dragenter', (event: DragEvent) => this.drag(event, 1)],
    ['dragleave', (event: DragEvent) => this.drag(event, -1)],
    ['dragover', (event: DragEvent) => this.drag(event, 0)],
    ['drop', (event: DragEvent) => this.drop(event)],
  ] as const;

  private drag(event: DragEvent, by: number): void {
    event.preventDefault();
    this.depth += by;
    this.over = this.depth > 0;
  }

  private drop(event: DragEvent): void {
    this.drag(event, -this.depth);
    this.give(event.dataTransfer?.files);
  }

  private onChoose(): void {
    this.give(this.input.files);
    this.input.value = '';
  }

  private give(files: FileList | null | undefined): void {
    const detail = [...(files ?? [])];
    if (detail.length > 0) this.dispatchEvent(new CustomEvent<File[]>('files', { detail }));
  }

  override render(): TemplateResult {
    const { texts } = this;
    return html`
      <h2>${texts.ownFile}</h2>
      <button title=${texts.dropHere} @click=${() => this.input.click()}>${texts.openFile}</button>
      <input
        type="file"
        multiple
        accept=${this.accept}
        @change=${this.onChoose}
        aria-label=${texts.openFile}
      />
      <p>${texts.dropHere}</p>
    `;
  }
}
