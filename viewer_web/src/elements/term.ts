import { LitElement, css, html } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property, query, state } from 'lit/decorators.js';
import type { FirstTerms, Term } from '../i18n/glossary.js';

/** An occurrence of a term, in its slot. Pressed, it shows what the term means. */
@customElement('vidno-term')
export class TermElement extends LitElement {
  static override styles = css`
    button {
      display: inline;
      padding: 0;
      border: 0;
      background: none;
      color: inherit;
      font: inherit;
      letter-spacing: inherit;
      text-align: inherit;
      text-decoration: underline dotted var(--soft) 1px;
      text-underline-offset: 0.2em;
      cursor: help;
    }
    button:hover,
    button[aria-expanded='true'] {
      text-decoration-color: var(--accent);
      text-decoration-thickness: 2px;
    }
    button:focus-visible {
      border-radius: 2px;
      outline: 2px solid var(--accent);
      outline-offset: 1px;
    }
    [popover] {
      position: fixed;
      inset: auto;
      box-sizing: border-box;
      width: max-content;
      max-width: min(22rem, calc(100vw - 1rem));
      margin: 0;
      padding: 0.6rem 0.75rem;
      border: 1px solid var(--line);
      border-radius: var(--radius);
      background: var(--panel);
      color: var(--ink);
      box-shadow: 0 4px 16px #0003;
      font: 0.9375rem / 1.45 var(--sans);
      hyphens: manual;
    }
    b {
      display: block;
    }
    @media print {
      /* A button is a box, and a line may end beside it, even before a full stop. */
      button {
        display: contents;
      }
    }
  `;

  @property({ attribute: false }) term!: Term;
  @state() private isOpen = false;
  @query('button') private readonly button!: HTMLButtonElement;
  @query('[popover]') private readonly popup!: HTMLElement;

  override render(): TemplateResult {
    return html`<button
        type="button"
        aria-expanded=${this.isOpen}
        aria-describedby="meaning"
        popovertarget="meaning"
        @keydown=${this.onKey}
      >
        <slot></slot></button
      ><span id="meaning" popover @beforetoggle=${this.onToggle} @toggle=${this.place}
        >${this.isOpen ? html`<b>${this.term.term}</b>${this.term.line}` : ''}</span
      >`;
  }

  private onToggle({ newState }: ToggleEvent): void {
    this.isOpen = newState === 'open';
  }

  /** The page has actions of its own for Escape, which must not run as well. */
  private onKey(event: KeyboardEvent): void {
    if (event.key !== 'Escape' || !this.isOpen) return;
    event.stopPropagation();
    event.preventDefault();
    this.popup.hidePopover();
  }

  /** Puts the meaning below the term, or above it where there is no room below. */
  private async place(): Promise<void> {
    if (!this.isOpen) return;
    await this.updateComplete;
    const gap = 6;
    const { left, top, bottom } = this.button.getBoundingClientRect();
    const { offsetWidth, offsetHeight, style } = this.popup;
    const isBelow = bottom + gap + offsetHeight <= innerHeight;
    style.left = `${Math.max(8, Math.min(left, innerWidth - offsetWidth - 8))}px`;
    style.top = `${isBelow ? bottom + gap : Math.max(8, top - gap - offsetHeight)}px`;
  }
}

/** A text in which the first occurrence of each term shows its meaning on demand. */
export function withTerms(text: string, first: FirstTerms): readonly (string | TemplateResult)[] {
  return first
    .split(text)
    .map((piece) =>
      piece.term === null
        ? piece.text
        : html`<vidno-term .term=${piece.term}>${piece.text}</vidno-term>`,
    );
}
