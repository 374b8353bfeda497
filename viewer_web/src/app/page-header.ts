import { LitElement, css, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { withKey } from '../base/key-map.js';
import type { PageView } from '../base/setting.js';
import { headerStyle } from '../elements/header.style.js';
import { base } from '../elements/theme.js';
import { texts } from '../i18n/index.js';
import type { Language } from '../language/language.js';

/** What the header's buttons ask for. */
export type Asked =
  | 'skip'
  | 'contents'
  | 'own'
  | 'atlas'
  | 'keys'
  | 'text'
  | 'workbench'
  | 'edit'
  | 'compare'
  | 'present';

/** What can be chosen from, over the page: the lessons, or the ways to a scene of the reader's own. */
export type Menu = 'lessons' | 'own';

/** A button of the header: its request, its label, its key, whether it is pressed or has opened a menu, and whether it is disabled. */
interface Tool {
  readonly ask: Asked;
  readonly label: string;
  readonly hint?: string;
  readonly key?: string;
  readonly isOn?: boolean;
  readonly isExpanded?: boolean;
  readonly off?: boolean;
}

/** The line at the top of the page. An event `ask` carries the request of a button. */
@customElement('vidno-page-header')
export class PageHeaderElement extends LitElement {
  static override styles = [
    base,
    headerStyle,
    css`
      header {
        height: 100%;
      }
      button {
        padding: 0 0.65rem;
        border-color: transparent;
        background: none;
        white-space: nowrap;
      }
      button:is([aria-pressed='true'], [aria-expanded='true']) {
        border-color: var(--accent);
        background: var(--accent-wash);
      }
      slot {
        display: flex;
        flex: 1;
        min-width: 0;
      }
      .tools {
        gap: 0.25rem;
      }
      .skip:not(:focus-visible) {
        position: absolute;
        width: 1px;
        min-height: 1px;
        padding: 0;
        overflow: hidden;
        clip-path: inset(50%);
      }
      .more {
        display: none;
      }
      @media (max-width: 1199px) {
        header {
          gap: 0.35rem;
        }
        button {
          padding: 0 0.4rem;
          font-size: 0.875rem;
        }
        .tools {
          gap: 0;
        }
      }
      /* There is no room for a name. */
      @media (min-width: 900px) and (max-width: 999px) {
        slot {
          visibility: hidden;
        }
        button {
          padding: 0 0.2rem;
          font-size: 0.8125rem;
        }
      }
      /* On a small screen the rarely used tools are hidden in a line of their own. */
      @media (max-width: 899px) {
        header {
          flex-wrap: wrap;
          gap: 0 0.35rem;
          height: auto;
        }
        button {
          padding: 0 0.5rem;
          font-size: 0.9375rem;
        }
        h1 {
          line-height: 2.75rem;
        }
        slot {
          order: 1;
          flex: 1 0 100%;
          min-height: 0;
        }
        .more {
          display: block;
          margin-left: auto;
          margin-right: calc(5rem * var(--languages));
        }
        .tools:not(.open) {
          display: none;
        }
        .tools {
          flex: 1 0 100%;
          flex-wrap: wrap;
          margin: 0;
        }
      }
      /* On a narrow screen the links to several languages leave no room for buttons: they share a line with the name. */
      @media (max-width: 389px) {
        h1 {
          margin-right: min(100% - 5rem, 100% * (var(--languages) - 1));
          font-size: 1.125rem;
        }
        header {
          gap: 0 0.2rem;
        }
        button {
          padding: 0 0.25rem;
          font-size: 0.875rem;
        }
        .more {
          margin-right: max(0rem, 5rem * (2 - var(--languages)));
        }
      }
    `,
  ];

  @property({ attribute: false }) language: Language = 'en';
  /** Whether a run is shown: the tools act on it. */
  @property({ type: Boolean }) open = false;
  /** Whether another run is beside it, and whether that is impossible. */
  @property({ type: Boolean }) comparing = false;
  @property({ type: Boolean }) alone = false;
  /** Whether the lesson has a text, and whether that text is shown. */
  @property({ type: Boolean, reflect: true, attribute: 'has-text' }) hasText = false;
  @property({ type: Boolean }) reading = false;
  @property() view: PageView = 'lesson';
  /** Whether the scene is being edited; null where it cannot be. */
  @property({ attribute: false }) editing: boolean | null = null;
  /** The open menu. */
  @property({ attribute: false }) menu: Menu | null = null;
  /** Whether the page has the atlas. */
  @property({ type: Boolean }) atlas = false;
  /** The key assignments, as written in an address. */
  @property({ attribute: false }) keys = '';
  /** Whether the tools are shown where there is no room for them. */
  @property({ type: Boolean, reflect: true }) more = false;

  override render(): TemplateResult {
    const { page } = texts[this.language];
    return html`<header>
      ${this.button({ ask: 'skip', label: page.skip })}
      <h1>vidno</h1>
      ${this.button({
        ask: 'contents',
        label: page.lessons,
        isExpanded: this.menu === 'lessons',
        off: this.comparing,
      })}
      ${this.text()}
      <slot></slot>
      <button
        class="more"
        aria-expanded=${this.more ? 'true' : 'false'}
        @click=${() => (this.more = !this.more)}
      >
        ${page.menu}
      </button>
      <div class="tools ${this.more ? 'open' : ''}">
        ${this.tools().map((each) => this.button(each))}
      </div>
    </header>`;
  }

  private text(): TemplateResult | typeof nothing {
    if (!this.hasText) return nothing;
    const { reader } = texts[this.language];
    return this.button({
      ask: 'text',
      label: reader.text,
      ...(this.reading ? { hint: reader.hide } : {}),
      key: 'R',
      isOn: this.reading,
    });
  }

  private tools(): readonly Tool[] {
    const { page, compare, scene, atlas } = texts[this.language];
    const { open, editing, comparing } = this;
    const own: Tool = {
      ask: 'own',
      label: page.own,
      hint: page.ownHint,
      isExpanded: this.menu === 'own',
      off: comparing,
    };
    return [
      own,
      ...(this.atlas ? [{ ask: 'atlas', label: atlas.short, hint: atlas.title } as const] : []),
      {
        ask: 'workbench',
        label: page.workbench,
        hint: page.workbenchHint,
        key: 'W',
        isOn: this.view === 'workbench',
        off: !open || comparing,
      },
      { ask: 'edit', label: scene.edit, key: 'E', isOn: editing === true, off: editing === null },
      {
        ask: 'compare',
        label: compare.compare,
        ...(comparing ? { hint: compare.leave } : {}),
        key: 'D',
        isOn: comparing,
        off: !open || this.alone,
      },
      { ask: 'present', label: page.present, key: 'F', isOn: false, off: !open },
      { ask: 'keys', label: page.keys, key: '?', off: !open },
    ];
  }

  private button({ ask, label, hint, key, isOn, isExpanded, off = false }: Tool): TemplateResult {
    const said = hint ?? label;
    const pressed = isOn === undefined ? nothing : isOn ? 'true' : 'false';
    return html`<button
      class=${ask}
      aria-pressed=${pressed}
      aria-expanded=${isExpanded ?? nothing}
      title=${key === undefined ? said : withKey(said, key)}
      ?disabled=${off}
      @click=${() => this.dispatchEvent(new CustomEvent<Asked>('ask', { detail: ask }))}
    >
      ${label}
    </button>`;
  }
}
