import { html, nothing } from 'lit';
import type { ReactiveController, ReactiveControllerHost, TemplateResult } from 'lit';
import type { View } from '../algorithm/view.js';
import type { Actions } from '../elements/keyboard.js';

/** What of the player is shown to a hall. */
export interface Presented extends ReactiveControllerHost, HTMLElement {
  readonly step: number;
  readonly last: number;
  readonly presenting: boolean;
  moveTo(step: number): void;
  present(on: boolean): void;
  handleKey(event: KeyboardEvent): void;
}

/** Shows the player to a hall: on the full screen where there is one, with the keys of remote controls. */
export class Presenter implements ReactiveController {
  /** The screen is dark: the hall looks at the speaker. */
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

  /** Where nobody has pressed anything, as after a link, or a frame may not, the window has to do. */
  private fill(): void {
    if (!document.fullscreenEnabled || !navigator.userActivation.isActive) return;
    void this.host.requestFullscreen().catch(() => undefined);
  }

  /** All that keys do: at a dark screen any of them makes it light again. */
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

  /** Instead of the controls: where one is, and the way out. */
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

  /** Over all when the screen is dark. */
  curtain(): TemplateResult | typeof nothing {
    if (!this.blank) return nothing;
    return html`<div class="curtain" @click=${() => this.darken(false)}></div>`;
  }

  private darken(blank: boolean): void {
    this.blank = blank;
    this.host.requestUpdate();
  }

  /** Escape leaves the full screen without being a key. */
  private readonly onFullscreen = (): void => {
    if (document.fullscreenElement === null && this.isOn) this.host.present(false);
  };

  /** Wherever the focus was when the rest of the page went out of sight. */
  private readonly onKey = (event: KeyboardEvent): void => {
    if (this.isOn) this.host.handleKey(event);
  };
}
