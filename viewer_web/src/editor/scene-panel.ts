import { css, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { showsOfEdited } from '../algorithm/shows.js';
import { withKey } from '../base/key-map.js';
import { base, lowScreen } from '../elements/theme.js';
import { texts } from '../i18n/index.js';
import { isOnDisk } from '../lessons/page-file.js';
import { whyRefused } from '../run/refusal.js';
import { reachesOut } from '../run/sketch.js';
import type { Act } from './editor.js';
import { FormElement, ask } from './form.js';
import type { LinkMade } from './live.js';
import './run-form.js';

/** Fixed tools and a message, and under them the form, which scrolls. */
const scenePanelStyle = css`
  :host {
    display: flex;
    flex-direction: column;
    min-height: 0;
    font-size: 0.8125rem;
  }
  .tools {
    display: flex;
    flex: none;
    flex-wrap: wrap;
    gap: 0.3rem;
    padding: 0.5rem 0.75rem 0;
    scroll-margin-bottom: 17.5rem; /* the dock */
  }
  @media ${lowScreen} {
    .tools {
      scroll-margin-bottom: 0;
    }
  }
  .tools button {
    padding: 0 0.55rem;
  }
  .tools .close {
    margin-left: auto;
    padding: 0;
  }
  .draw[aria-pressed='true'] {
    background: var(--accent);
    border-color: var(--accent);
    color: var(--on-accent);
  }
  .message {
    flex: none;
    height: 4.4rem;
    margin: 0.5rem 0.75rem;
    padding: 0.3rem 0.5rem;
    overflow: auto;
    border-radius: 6px;
    background: var(--well);
    color: var(--soft);
    font-size: 0.75rem;
  }
  .message span {
    white-space: pre-line;
  }
  .message.refused {
    background: var(--bad-wash);
    color: var(--bad);
  }
  .scroll {
    position: relative;
    flex: 1;
    min-height: 0;
    overflow: auto;
    padding: 0 0.75rem 0.75rem;
    scrollbar-width: thin;
  }
  .icon {
    width: 2rem;
    font-size: 1.05rem;
    line-height: 1;
  }
`;

/**
 * The scene as a form, with the actions on the whole scene, and the library's messages. An event `close` asks to close it.
 */
@customElement('vidno-scene-panel')
export class ScenePanelElement extends FormElement {
  static override styles = [base, scenePanelStyle];

  @property({ attribute: false }) link: LinkMade | null = null;
  /** Whether an address can reopen the scene. */
  @property({ type: Boolean }) linked = false;

  override render(): TemplateResult {
    const { editing, language } = this;
    const { form, isSolid } = showsOfEdited(editing);
    const run = html`<vidno-run-form .editing=${editing} .language=${language}></vidno-run-form>`;
    // A surface is one formula, which must be in sight.
    const [first, second] = isSolid
      ? [run, form(editing, language)]
      : [form(editing, language), run];
    return html`
      ${this.tools()} ${this.message()}
      <div class="scroll">${first} ${second}</div>
    `;
  }

  /** On a small screen it is below the picture. */
  async bringIntoSight(): Promise<void> {
    await this.updateComplete;
    this.renderRoot.querySelector('.tools')?.scrollIntoView({ block: 'nearest' });
  }

  private tools(): TemplateResult {
    const { say, editing } = this;
    return html`<div class="tools" role="group">
      ${this.icon('↶', `${say.undo} (Ctrl+Z)`, !editing.canUndo, { do: 'undo' })}
      ${this.icon('↷', `${say.redo} (Ctrl+Y)`, !editing.canRedo, { do: 'redo' })}
      ${showsOfEdited(editing).isSolid ? this.drawing() : nothing}
      <button title=${say.saveHint} @click=${() => ask(this, 'vidno-save')}>${say.save}</button>
      ${this.sharing()}
      <button
        class="icon close"
        aria-label=${texts[this.language].page.close}
        title=${withKey(texts[this.language].page.close, 'E')}
        @click=${() => this.dispatchEvent(new CustomEvent('close'))}
      >
        ✕
      </button>
    </div>`;
  }

  private drawing(): TemplateResult {
    const { say, editing } = this;
    const isDrawing = editing.drawn !== null;
    return html`<button
        class="draw"
        aria-pressed=${isDrawing ? 'true' : 'false'}
        title="${say.draw} (N)"
        @click=${() => this.act({ do: isDrawing ? 'cancel' : 'draw' })}
      >
        ${say.draw}
      </button>
      <button title=${say.clearHint} @click=${() => this.act({ do: 'new' })}>${say.clear}</button>`;
  }

  private sharing(): TemplateResult {
    const { say, linked, link } = this;
    const isLink = linked && link !== 'tooLong' && !isOnDisk();
    return html`<button
      title=${isLink ? say.linkHint : say.pageHint}
      @click=${() => ask(this, 'vidno-link')}
    >
      ${isLink ? say.link : say.page}
    </button>`;
  }

  private icon(sign: string, label: string, off: boolean, act: Act): TemplateResult {
    return html`<button
      class="icon"
      aria-label=${label}
      title=${label}
      ?disabled=${off}
      @click=${() => this.act(act)}
    >
      ${sign}
    </button>`;
  }

  /** A place for messages. It is always there, so that nothing moves when one appears. */
  private message(): TemplateResult {
    const { say, editing, link } = this;
    const { refused, messages, sketch } = editing;
    if (refused) {
      const why = whyRefused(messages, sketch, say);
      return html`<p class="message refused" role="alert" tabindex="0">
        <span>${why}. ${say.stands}</span>
      </p>`;
    }
    return html`<p class="message" role="status" tabindex="0">
      <span>${this.news(link, messages.trim())}</span>
    </p>`;
  }

  private news(link: LinkMade | null, messages: string): string {
    const { say, editing } = this;
    const said = { copied: say.linkCopied, saved: say.pageSaved, tooLong: say.linkTooLong };
    if (link !== null) return said[link];
    if (editing.drawn !== null) return say.drawing;
    if (messages !== '') return messages;
    return reachesOut(editing.sketch)
      ? say.howOutside
      : showsOfEdited(editing).how(texts[this.language]);
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'vidno-scene-panel': ScenePanelElement;
  }
}
