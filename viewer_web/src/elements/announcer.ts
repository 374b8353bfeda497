import { html } from 'lit';
import type { ReactiveControllerHost, TemplateResult } from 'lit';
import { keyed } from 'lit/directives/keyed.js';

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
