import { css, html } from 'lit';
import type { ReactiveControllerHost, TemplateResult } from 'lit';
import { keyed } from 'lit/directives/keyed.js';

/** Over the content, for long enough to be read, without moving anything. */
export const announcerStyle = css`
  .news {
    position: absolute;
    z-index: 4;
    bottom: 100%;
    left: 50%;
    width: max-content;
    max-width: min(36rem, 100%);
    transform: translate(-50%, -0.5rem);
  }
  .news {
    pointer-events: none;
  }
  .news span:not(.heard, :empty) {
    display: block;
    padding: 0.5rem 0.9rem;
    border-radius: 6px;
    background: var(--ink);
    color: var(--panel);
  }
  .news span:not(.heard, :empty) {
    animation: gone 0.3s 7s forwards;
  }
  @keyframes gone {
    to {
      visibility: hidden;
      opacity: 0;
    }
  }
`;

/** Announces effects of keys that not everyone can see; shows to everyone why a key had no effect. */
export class Announcer {
  private said = '';
  private isShown = false;
  private count = 0;

  constructor(private readonly host: ReactiveControllerHost) {}

  /** Announces a text to screen readers. */
  say(text: string): void {
    this.tell(text, false);
  }

  /** Shows why something was not done. */
  refuse(text: string): void {
    this.tell(text, true);
  }

  private tell(text: string, isShown: boolean): void {
    this.said = text;
    this.isShown = isShown;
    this.count++;
    this.host.requestUpdate();
  }

  render(): TemplateResult {
    return html`<div class="news" role="status">
      ${keyed(this.count, html`<span class=${this.isShown ? '' : 'heard'}>${this.said}</span>`)}
    </div>`;
  }
}
