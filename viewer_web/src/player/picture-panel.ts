import { LitElement, css, html } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property, query, state } from 'lit/decorators.js';
import { showsOf } from '../algorithm/shows.js';
import type { LayerChoice } from '../algorithm/shows.js';
import type { View } from '../algorithm/view.js';
import type { Editing } from '../editor/editor.js';
import { base } from '../elements/theme.js';
import type { Exact, Layer } from '../picture/layers.js';
import '../picture/legend.js';
import type { Pixel } from '../picture/pixel.js';
import type { PlaneElement } from '../picture/plane.js';
import '../picture/save.js';
import type { Kind, SaveElement } from '../picture/save.js';

/**
 * The picture, the choice of what it shows, and the legend. An event `pixel` tells that one was chosen.
 */
@customElement('vidno-picture-panel')
export class PicturePanelElement extends LitElement {
  static override styles = [
    base,
    css`
      :host {
        display: flex;
        flex-direction: column;
        min-height: 0;
      }
      .drawing {
        flex: 1;
        min-height: var(--least-picture, 0px);
      }
      .layers,
      .switches,
      vidno-legend {
        flex: none;
        display: var(--signs, var(--legend, block));
      }
      .layers,
      .switches {
        display: var(--tools, var(--legend, flex));
      }
    `,
  ];

  @property({ attribute: false }) view!: View;
  @property({ attribute: false }) editing: Editing | null = null;
  @property({ attribute: false }) layer: Layer = 'picture';
  @property({ attribute: false }) exact: Exact = null;
  /** The parts that are shown, by all that there are. */
  @state() private parts: ReadonlyMap<ReadonlySet<string>, ReadonlySet<string>> = new Map();
  @query('.drawing') private drawing!: PlaneElement;
  @query('.layers') private choice!: LayerChoice;
  @query('vidno-save') private saver!: SaveElement;

  /** Gives the keyboard to the choice of a pixel. */
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
      <vidno-legend .view=${view}>
        <vidno-save .view=${view}></vidno-save>
      </vidno-legend>
    `;
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'vidno-picture-panel': PicturePanelElement;
  }
}
