import { LitElement, css, html, nothing } from 'lit';
import type { PropertyValues, TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { texts } from '../i18n/index.js';
import { caption } from './scene.js';
import { Space } from './space.js';
import type { View } from '../algorithm/view.js';
import './solid-stage.js';
import { base, hiddenStyle } from '../elements/theme.js';

/** The 3D view, with a description of the step. */
@customElement('vidno-solid')
export class SolidElement extends LitElement {
  static override styles = [
    base,
    hiddenStyle,
    css`
      :host {
        display: flex;
        flex-direction: column;
        min-height: 0;
      }
      vidno-solid-stage {
        flex: 1;
        min-height: 0;
      }
      .caption {
        flex: none;
        height: var(--caption, 11em);
        padding: 0.4rem 0.75rem;
        overflow: auto;
        scrollbar-width: thin;
        border-top: 1px solid var(--line);
        font-size: 0.75rem;
        line-height: 1.4;
      }
      .caption:focus-visible {
        outline-offset: -4px;
      }
      .caption p:first-child {
        color: var(--soft);
      }
      @container (min-width: 1500px) {
        .caption {
          font-size: 0.875rem;
        }
      }
    `,
  ];

  @property({ attribute: false }) view!: View;
  /** In a presentation the description is for screen readers only. */
  @property({ type: Boolean }) bare = false;
  private space!: Space;

  override willUpdate(changed: PropertyValues<this>): void {
    const { scene } = this.view.header;
    if (changed.get('view')?.header.scene !== scene) this.space = new Space(scene);
  }

  override render(): TemplateResult {
    const { view, space } = this;
    const { solid } = texts[view.language];
    return html`
      <vidno-solid-stage .view=${view} .space=${space}></vidno-solid-stage>
      <div
        class=${this.bare ? 'heard' : 'caption'}
        tabindex=${this.bare ? nothing : 0}
        role="region"
        aria-label=${solid.title}
      >
        ${caption(view, space, solid).map((words) => html`<p>${words}</p>`)}
      </div>
    `;
  }
}
