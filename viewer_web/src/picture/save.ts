import { LitElement, css, html } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { algorithmOf } from '../algorithm/algorithm.js';
import type { View } from '../algorithm/view.js';
import { download, fileName } from '../base/file.js';
import { withKey } from '../base/key-map.js';
import { base } from '../elements/theme.js';

/** The width in pixels: enough for a slide or a column of print. */
const width = 2000;

const kinds = [
  ['svg', 'S'],
  ['png', 'Shift S'],
] as const;

export type Kind = (typeof kinds)[number][0];

/** Saves the picture of the current step. */
@customElement('vidno-save')
export class SaveElement extends LitElement {
  static override styles = [
    base,
    css`
      :host {
        display: flex;
        gap: 0.25rem;
      }
      button {
        min-height: 1.5rem;
        padding: 0 0.4rem;
        color: var(--soft);
        font-size: 0.75rem;
      }
    `,
  ];

  @property({ attribute: false }) view!: View;

  async save(kind: Kind): Promise<void> {
    const { view } = this;
    const { header, step } = view;
    const { scene, method, kernel, edition } = header;
    const name = `${fileName(scene.name, method, kernel, edition, `step-${step}`)}.${kind}`;
    const figure = algorithmOf(view.header).figure(view);
    const svg = new Blob([figure], { type: 'image/svg+xml' });
    download(kind === 'svg' ? svg : await pngOf(figure, width), name);
  }

  override render(): TemplateResult {
    return html`${kinds.map(([kind, key]) => this.button(kind, key))}`;
  }

  private button(kind: Kind, key: string): TemplateResult {
    const label = this.view.texts.savePicture(kind.toUpperCase());
    return html`<button
      aria-label=${label}
      title=${withKey(label, key)}
      @click=${() => void this.save(kind)}
    >
      ${kind.toUpperCase()}
    </button>`;
  }
}

/** An SVG document as an image of a width in pixels. */
async function pngOf(figure: string, width: number): Promise<Blob> {
  const address = URL.createObjectURL(new Blob([figure], { type: 'image/svg+xml' }));
  try {
    const image = new Image();
    image.src = address;
    await image.decode();
    const canvas = document.createElement('canvas');
    canvas.width = width;
    canvas.height = Math.round((width * image.naturalHeight) / image.naturalWidth);
    canvas.getContext('2d')?.drawImage(image, 0, 0, canvas.width, canvas.height);
    return await encoded(canvas);
  } finally {
    URL.revokeObjectURL(address);
  }
}

function encoded(canvas: HTMLCanvasElement): Promise<Blob> {
  return new Promise((resolve, reject) => {
    canvas.toBlob((blob) => {
      if (blob === null) reject(new Error('no image'));
      else resolve(blob);
    }, 'image/png');
  });
}
