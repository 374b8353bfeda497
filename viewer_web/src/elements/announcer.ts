import { html } from 'lit';
import type { ReactiveControllerHost, TemplateResult } from 'lit';
import { keyed } from 'lit/directives/keyed.js';

/** Says what a key has done that is not in sight of everyone; what it has not done, for everyone. */
export class Announcer {
  private said = '';
  private isShown = false;
  private count = 0;

  constructor(private readonly host: ReactiveControllerHost) {}

  /** For those who hear the page. */
  say(text: string): void {
    this.tell(text, false);
  }

  /** Why something was not done. */
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
