import { LitElement, css, html } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property, state } from 'lit/decorators.js';
import type { ReaderTexts } from '../language/texts.js';
import { base } from '../elements/theme.js';

/** Milliseconds for which the message about copying is shown. */
const noticed = 2000;

/** A line of a command, which may break between words but not inside one, such as after the `-` of an option. */
function line(text: string): TemplateResult {
  const parts = text.split(/(\s+)/);
  return html`<span class="line"
    >${parts.map((part, i) => (i % 2 === 0 ? html`<span class="word">${part}</span>` : part))}</span
  >`;
}

/** A command to try in a terminal, with a button that copies it. */
@customElement('vidno-command')
export class CommandElement extends LitElement {
  static override styles = [
    base,
    css`
      :host {
        display: flex;
        gap: 0.5rem;
        align-items: flex-start;
        padding: 0.5rem 0.5rem 0.5rem 0.75rem;
        border: 1px solid var(--line);
        border-radius: 6px;
        background: var(--well);
        font: 0.8125rem / 1.5 var(--mono);
      }
      :host([small]) {
        padding: 0.15rem 0 0;
        border: 0;
        background: none;
        color: var(--soft);
        font-size: 0.6875rem;
      }
      pre {
        flex: 1;
        min-width: 0;
        margin: 0;
        padding: 0.2rem 0;
        font: inherit;
        white-space: pre-wrap;
        overflow-wrap: anywhere;
      }
      .line {
        display: block;
        padding-left: 1.5em;
        text-indent: -1.5em;
      }
      .word {
        display: inline-block;
        max-width: 100%;
        text-indent: 0;
      }
      button {
        flex: none;
        min-height: 1.625rem;
        padding: 0 0.6rem;
        color: var(--soft);
        font: 0.75rem var(--sans);
      }
      :host([small]) button {
        border-color: transparent;
        background: none;
      }
      button:hover {
        color: var(--ink);
      }
      @media print {
        :host {
          break-inside: avoid;
        }
        button {
          display: none;
        }
      }
    `,
  ];

  @property() text = '';
  @property({ attribute: false }) texts!: ReaderTexts;
  @property({ type: Boolean, reflect: true }) small = false;
  @state() private isCopied = false;

  override render(): TemplateResult {
    const { copy, copied } = this.texts;
    return html`<pre><code>${this.text.trimEnd().split('\n').map(line)}</code></pre>
      <button aria-live="polite" @click=${this.copy}>${this.isCopied ? copied : copy}</button>`;
  }

  private async copy(): Promise<void> {
    await navigator.clipboard.writeText(this.text.trimEnd());
    this.isCopied = true;
    setTimeout(() => (this.isCopied = false), noticed);
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'vidno-command': CommandElement;
  }
}
