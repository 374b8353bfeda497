import { LitElement, css, html } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property, query, state } from 'lit/decorators.js';
import { showsOf } from '../algorithm/shows.js';
import type { LayerChoice } from '../algorithm/shows.js';
import type { View } from '../algorithm/view.js';
import type { Editing } from '../editor/editor.js';
import { base, zoomButtons } from '../elements/theme.js';
import type { Exact, Layer } from '../picture/layers.js';
import '../picture/legend.js';
import type { Pixel } from '../picture/pixel.js';
import type { PlaneElement } from '../picture/plane.js';
import '../picture/readout.js';
import '../picture/save.js';
import type { Kind, SaveElement } from '../picture/save.js';

/** The picture, its layer controls, and the legend. An event `pixel` carries a chosen pixel. */
@customElement('vidno-picture-panel')
export class PicturePanelElement extends LitElement {
  static override styles = [
    base,
    css`
      /* The picture; below it, in one line, the readout of the pointer and the controls of the picture. */
      :host {
        position: relative;
        display: grid;
        grid-template: minmax(0, 1fr) / minmax(0, 1fr) auto auto;
        grid-auto-rows: auto;
        min-height: 0;
      }
      .drawing {
        grid-column: 1 / -1;
        min-height: var(--least-picture, 0px);
      }
      vidno-readout {
        display: var(--readout, var(--legend, flex));
        order: 1;
        min-height: var(--foot, 2.25rem);
        padding: 0 0.75rem;
      }
      vidno-layers {
        order: 2;
      }
      .switches,
      vidno-curve-layers {
        grid-column: 1 / -1;
      }
      vidno-legend {
        order: 3;
        align-items: center;
        padding-right: 0.6rem;
      }
      .layers,
      .switches,
      vidno-legend {
        display: var(--tools, var(--legend, flex));
      }
      /* The zoom buttons lie over the picture's upper margin. */
      @container (max-width: 520px) {
        .drawing {
          min-height: calc(var(--least-picture, 0px) + ${zoomButtons});
        }
        vidno-readout {
          grid-column: 1 / 3;
          min-height: var(--foot, 1.75rem);
        }
        vidno-layers {
          grid-column: 1 / -1;
          order: 4;
          padding-left: 0.6rem;
        }
      }
      /* Beside the text of a lesson there is no line for the readout: it lies in the picture's lower margin. */
      @media (max-width: 899px) {
        vidno-readout {
          position: var(--readout-position, static);
          inset: auto auto 0 0;
          max-width: calc(100% - 6rem);
          border-radius: 0 6px 0 0;
          background: var(--panel);
        }
      }
      .switches,
      vidno-curve-layers,
      vidno-legend {
        visibility: var(--quiet, visible);
      }
    `,
  ];

  @property({ attribute: false }) view!: View;
  @property({ attribute: false }) editing: Editing | null = null;
  @property({ attribute: false }) layer: Layer = 'picture';
  @property({ attribute: false }) exact: Exact = null;
  /** The visible parts, by the set of all possible parts. */
  @state() private parts: ReadonlyMap<ReadonlySet<string>, ReadonlySet<string>> = new Map();
  /** The pixel under the pointer. */
  @state() private pointed: Pixel | null = null;
  @query('.drawing') private drawing!: PlaneElement;
  @query('.layers') private choice!: LayerChoice;
  @query('vidno-save') private saver!: SaveElement;

  constructor() {
    super();
    this.addEventListener('pointed', ({ detail }) => (this.pointed = detail));
  }

  /** Moves the focus to the picture, to choose a pixel. */
  startChoosing(): void {
    this.drawing.startChoosing();
  }

  save(kind: Kind): Promise<void> {
    return this.saver.save(kind);
  }

  nextLayer(): void {
    this.choice.next();
  }

  shownOf<T extends string>(all: ReadonlySet<T>): ReadonlySet<T> {
    return (this.parts.get(all) ?? all) as ReadonlySet<T>;
  }

  show<T extends string>(some: ReadonlySet<T>, all: ReadonlySet<T>): void {
    this.parts = new Map(this.parts).set(all, some);
  }

  choose(detail: Pixel): void {
    this.dispatchEvent(new CustomEvent<Pixel>('pixel', { detail }));
  }

  override render(): TemplateResult {
    const { view } = this;
    return html`
      ${showsOf(view).picture(this)}
      <vidno-readout .view=${view} .at=${this.pointed ?? view.pixel}></vidno-readout>
      <vidno-legend .view=${view}>
        <vidno-save .view=${view}></vidno-save>
      </vidno-legend>
    `;
  }
}

declare global {
  interface HTMLElementEventMap {
    pointed: CustomEvent<Pixel | null>;
  }
  interface HTMLElementTagNameMap {
    'vidno-picture-panel': PicturePanelElement;
  }
}
