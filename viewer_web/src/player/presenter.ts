import { html, nothing } from 'lit';
import type { ReactiveController, ReactiveControllerHost, TemplateResult } from 'lit';
import type { View } from '../algorithm/view.js';
import type { Actions } from '../elements/keyboard.js';

/** The parts of the player that a presentation uses. */
export interface Presented extends ReactiveControllerHost, HTMLElement {
  readonly step: number;
  readonly last: number;
  readonly presenting: boolean;
  moveTo(step: number): void;
  present(on: boolean): void;
  handleKey(event: KeyboardEvent): void;
}

/** Presents the player to an audience: in full screen where possible, with the keys of presenter remotes. */
export class Presenter implements ReactiveController {
  /** Whether the screen is blanked, so that the audience looks at the speaker. */
  blank = false;
  private isOn = false;

  constructor(private readonly host: Presented) {
    host.addController(this);
  }

  hostConnected(): void {
    document.addEventListener('fullscreenchange', this.onFullscreen);
    window.addEventListener('keydown', this.onKey);
  }

  hostDisconnected(): void {
    document.removeEventListener('fullscreenchange', this.onFullscreen);
    window.removeEventListener('keydown', this.onKey);
  }

  hostUpdated(): void {
    const { presenting } = this.host;
    if (presenting === this.isOn) return;
    this.isOn = presenting;
    this.blank = false;
    if (presenting) this.fill();
    else if (document.fullscreenElement !== null) void document.exitFullscreen();
  }

  /** Enters full screen. Without a user action, as after a link, or in a frame without permission, the window remains. */
  private fill(): void {
    if (!document.fullscreenEnabled || !navigator.userActivation.isActive) return;
    void this.host.requestFullscreen().catch(() => undefined);
  }

  /** The actions of all keys. On a blank screen any key shows the picture again. */
  actions(usual: Actions): Actions {
    const { host } = this;
    const light = (): void => this.darken(false);
    const dark = (): void => this.darken(true);
    const all: Actions = {
      ...usual,
      PageDown: () => host.moveTo(host.step + 1),
      PageUp: () => host.moveTo(host.step - 1),
      '.': dark,
      Period: dark,
      KeyB: dark,
      Escape: () => host.present(false),
    };
    if (!this.blank) return all;
    return Object.fromEntries(Object.keys(all).map((key) => [key, light]));
  }

  /** Shown in place of the controls: the current step and the exit. */
  corner({ step, texts }: View): TemplateResult | typeof nothing {
    if (!this.host.presenting) return nothing;
    return html`<div class="corner">
      <span class="number">${step} / ${this.host.last}</span>
      <button
        aria-label=${texts.leave}
        title="${texts.leave} (Esc)"
        @click=${() => this.host.present(false)}
      >
        ✕
      </button>
    </div>`;
  }

  /** Covers everything while the screen is blank. */
  curtain(): TemplateResult | typeof nothing {
    if (!this.blank) return nothing;
    return html`<div class="curtain" @click=${() => this.darken(false)}></div>`;
  }

  private darken(blank: boolean): void {
    this.blank = blank;
    this.host.requestUpdate();
  }

  /** Escape leaves the full screen without a key event. */
  private readonly onFullscreen = (): void => {
    if (document.fullscreenElement === null && this.isOn) this.host.present(false);
  };

  /** Handles keys wherever the focus was when the rest of the page was hidden. */
  private readonly onKey = (event: KeyboardEvent): void => {
    if (this.isOn) this.host.handleKey(event);
  };
}
