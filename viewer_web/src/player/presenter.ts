import { html, nothing } from 'lit';
import type { ReactiveController, ReactiveControllerHost, TemplateResult } from 'lit';
import type { View } from '../algorithm/view.js';
import type { Announcer } from '../elements/announcer.js';
import type { Actions } from '../elements/keyboard.js';
import { texts } from '../i18n/index.js';
import type { Language } from '../language/language.js';
import './pen.js';
import { tools } from './pen.js';
import type { Tool } from './pen.js';

/** The room that the content of a hall needs, in CSS pixels; a larger screen enlarges it. */
const needed = { width: 800, height: 500 };

/** The parts of the player that a presentation uses. */
export interface Presented extends ReactiveControllerHost, HTMLElement {
  readonly step: number;
  readonly last: number;
  readonly presenting: boolean;
  readonly language: Language;
  readonly announcer: Announcer;
  moveTo(step: number): void;
  present(on: boolean): void;
  handleKey(event: KeyboardEvent): void;
}

/** Keeps Escape for the page, where a browser can: it puts the pen away and does not leave the full screen. */
interface LockingKeys {
  readonly keyboard?: { lock(keys: readonly string[]): Promise<void> };
}

/** Presents the player to an audience: in full screen where possible, with the keys of presenter remotes. */
export class Presenter implements ReactiveController {
  /** Whether the screen is blanked, so that the audience looks at the speaker. */
  blank = false;
  private tool: Tool | null = null;
  private isOn = false;

  constructor(private readonly host: Presented) {
    host.addController(this);
  }

  hostConnected(): void {
    document.addEventListener('fullscreenchange', this.onFullscreen);
    window.addEventListener('keydown', this.wake, true);
    window.addEventListener('keydown', this.onKey);
    window.addEventListener('resize', this.enlarge);
  }

  hostDisconnected(): void {
    document.removeEventListener('fullscreenchange', this.onFullscreen);
    window.removeEventListener('keydown', this.wake, true);
    window.removeEventListener('keydown', this.onKey);
    window.removeEventListener('resize', this.enlarge);
  }

  hostUpdated(): void {
    const { presenting } = this.host;
    if (presenting === this.isOn) return;
    this.isOn = presenting;
    this.blank = false;
    this.tool = null;
    this.enlarge();
    if (presenting) this.fill();
    else if (document.fullscreenElement !== null) void document.exitFullscreen();
  }

  /** Enters full screen. Without a user action, as after a link, or in a frame without permission, the window remains. */
  private fill(): void {
    if (!document.fullscreenEnabled || !navigator.userActivation.isActive) return;
    const { keyboard } = navigator as LockingKeys;
    const filled = this.host.requestFullscreen().then(() => keyboard?.lock(['Escape']));
    void filled.catch(() => undefined);
  }

  /** The actions of all keys. */
  actions(usual: Actions): Actions {
    const { host } = this;
    const dark = (): void => this.darken(true);
    return {
      ...usual,
      PageDown: () => host.moveTo(host.step + 1),
      PageUp: () => host.moveTo(host.step - 1),
      '.': dark,
      Period: dark,
      KeyB: dark,
      KeyP: () => this.take(tools[this.tool === null ? 0 : tools.indexOf(this.tool) + 1] ?? null),
      Escape: () => (this.tool === null ? host.present(false) : this.take(null)),
    };
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

  /** What lies over everything: the pointer or the pen, and the black screen. */
  cover(): TemplateResult {
    const { tool, blank } = this;
    return html`${tool === null ? nothing : html`<vidno-pen .tool=${tool}></vidno-pen>`}
    ${blank ? html`<div class="curtain" @click=${() => this.darken(false)}></div>` : nothing}`;
  }

  private darken(blank: boolean): void {
    const { host } = this;
    const { news } = texts[host.language].page;
    this.blank = blank;
    host.announcer.say(blank ? news.dark : news.light);
  }

  private take(tool: Tool | null): void {
    const { host } = this;
    this.tool = tool;
    host.announcer.say(texts[host.language].page.news[tool ?? 'noPen']);
  }

  /** On a black screen any key shows the picture again, and does nothing else. */
  private readonly wake = (event: KeyboardEvent): void => {
    const { key, ctrlKey, metaKey, altKey } = event;
    if (!this.blank || ctrlKey || metaKey || altKey || key === 'Shift') return;
    event.preventDefault();
    event.stopImmediatePropagation();
    this.darken(false);
  };

  private readonly enlarge = (): void => {
    const zoom = Math.min(innerWidth / needed.width, innerHeight / needed.height);
    this.host.style.zoom = this.isOn && zoom > 1 ? String(zoom) : '';
  };

  /** Escape leaves the full screen without a key event. */
  private readonly onFullscreen = (): void => {
    if (document.fullscreenElement === null && this.isOn) this.host.present(false);
  };

  /** Handles keys wherever the focus was when the rest of the page was hidden. */
  private readonly onKey = (event: KeyboardEvent): void => {
    if (this.isOn) this.host.handleKey(event);
  };
}
