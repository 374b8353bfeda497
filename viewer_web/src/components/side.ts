import { LitElement, css, html } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import type { History } from '../history/history.js';
import { texts } from '../i18n/index.js';
import type { View } from '../view.js';
import './history.js';
import { base } from './theme.js';
import './warnock-panel.js';
import './zbuffer-panel.js';

export type Side = 'state' | 'pixel';

/** One of two panels: the state of the procedure, or the history of a pixel. */
@customElement('vidno-side')
export class SideElement extends LitElement {
  static override styles = [
    base,
    css`
      :host {
        display: flex;
        flex-direction: column;
        min-height: 0;
      }
      :host > :not(.choice) {
        flex: 1;
        min-height: 0;
      }
      .choice {
        display: flex;
        flex: none;
        gap: 0.25rem;
        height: 2.6rem;
        padding: 0 0.5rem;
        border-bottom: 1px solid var(--line);
      }
      button {
        padding: 0.2rem 0.5rem 0;
        border: 0;
        border-bottom: 3px solid transparent;
        border-radius: 0;
        background: none;
        color: var(--soft);
        font-size: 0.8125rem;
        font-weight: 600;
        white-space: nowrap;
      }
      button[aria-pressed='true'] {
        border-color: var(--accent);
        color: var(--ink);
      }
      button:focus-visible {
        outline-offset: -4px;
      }
    `,
  ];

  @property({ attribute: false }) view!: View;
  @property({ attribute: false }) history: History | null = null;
  @property({ attribute: false }) side: Side = 'state';

  override render(): TemplateResult {
    const { view, history } = this;
    const { history: say } = texts[view.language];
    const pixel = history === null ? say.pixel : say.at(...history.pixel);
    return html`
      <div class="choice" role="group">
        ${this.button('state', view.texts.state)} ${this.button('pixel', pixel)}
      </div>
      ${this.panel()}
    `;
  }

  private panel(): TemplateResult {
    const { view, history, side } = this;
    if (side === 'pixel') {
      return html`<vidno-history
        .view=${view}
        .history=${history}
        @command=${this.passOn}
        @forget=${this.passOn}
      ></vidno-history>`;
    }
    return view.header.method === 'warnock'
      ? html`<vidno-warnock .view=${view}></vidno-warnock>`
      : html`<vidno-zbuffer .view=${view}></vidno-zbuffer>`;
  }

  private button(side: Side, label: string): TemplateResult {
    return html`<button
      aria-pressed=${side === this.side ? 'true' : 'false'}
      @click=${() => this.dispatchEvent(new CustomEvent('side', { detail: side }))}
    >
      ${label}
    </button>`;
  }

  private passOn({ type, detail }: CustomEvent<unknown>): void {
    this.dispatchEvent(new CustomEvent(type, { detail }));
  }
}
