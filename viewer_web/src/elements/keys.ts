import { LitElement, css, html } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property, query } from 'lit/decorators.js';
import type { KeyUse } from '../language/texts.js';
import type { PageTexts } from '../language/texts.js';
import { keyMap, keyName, letters } from '../base/key-map.js';
import { base, dialogStyle } from './theme.js';

const keys: readonly (readonly [use: KeyUse, keys: readonly string[]])[] = [
  ['step', ['←', '→']],
  ['ten', ['Shift ←', 'Shift →']],
  ['over', ['[', ']']],
  ['out', ['Shift [', 'Shift ]']],
  ['goal', [',', '.']],
  ['ends', ['Home', 'End']],
  ['play', ['Space']],
  ['speed', ['−', '+']],
  ['part', ['+', '−', '0', 'Shift PgUp', 'Shift PgDn']],
  ['pixel', ['P']],
  ['cursor', ['← ↑ ↓ →', 'Enter', 'Esc']],
  ['zoom', ['+', '−', '0']],
  ['layer', ['L']],
  ['mark', ['L']],
  ['predict', ['Q']],
  ['answer', ['1 … 9', 'Enter']],
  ['bookmark', ['B']],
  ['bookmarks', ['Shift B']],
  ['toBookmark', ['Shift ,', 'Shift .']],
  ['thing', ['O', 'Shift O']],
  ['source', ['C']],
  ['outline', ['T', 'Shift T']],
  ['inOutline', ['↑ ↓ ← →', 'Enter', '/']],
  ['exact', ['X']],
  ['solid', ['V']],
  ['turn', ['← ↑ ↓ →', '+', '−', '0']],
  ['edit', ['E']],
  ['draw', ['N']],
  ['undo', ['Ctrl Z', 'Ctrl Y']],
  ['corner', ['← ↑ ↓ →', 'PgUp', 'PgDn', '+', 'Del']],
  ['present', ['F']],
  ['remote', ['PgDn', 'PgUp', 'B', '.', 'Esc']],
  ['pen', ['P']],
  ['compare', ['D']],
  ['parting', ['J', 'Shift J']],
  ['save', ['S', 'Shift S']],
  ['reader', ['R']],
  ['workbench', ['W']],
  ['map', ['?']],
];

/** The keys that exist only for a single run, and only for a comparison. */
const only: Readonly<Record<'one' | 'pair', ReadonlySet<KeyUse>>> = {
  one: new Set([
    'layer',
    'predict',
    'answer',
    'bookmarks',
    'outline',
    'inOutline',
    'exact',
    'solid',
    'turn',
    'reader',
    'workbench',
  ]),
  pair: new Set(['mark', 'parting']),
};

/** The keys that exist only with a 3D view. */
const solid: readonly KeyUse[] = ['solid', 'turn'];

/** The map of keys and its settings. An event `vidno-keys` carries changed settings as a word. */
@customElement('vidno-keys')
export class KeysElement extends LitElement {
  static override styles = [
    base,
    dialogStyle,
    css`
      dialog {
        max-width: min(72rem, calc(100vw - 2rem));
      }
      dl {
        columns: 2 24rem;
        column-gap: 2rem;
      }
      dl div {
        display: grid;
        grid-template-columns: minmax(7rem, 35%) 1fr;
        gap: 0.75rem;
        align-items: baseline;
        padding: 0.15rem 0;
        break-inside: avoid;
      }
      dd {
        font-size: 0.875rem;
      }
      kbd {
        display: inline-block;
        margin: 0 0.3rem 0.1rem 0;
        padding: 0.05rem 0.45rem;
        border: 1px solid var(--line);
        border-bottom-width: 2px;
        border-radius: 5px;
        background: var(--well);
        font: 0.8125rem var(--mono);
      }
      kbd:has(input) {
        padding: 0;
      }
      kbd input {
        width: 1.75rem;
        min-height: 1.5rem;
        padding: 0;
        border: 0;
        background: none;
        font: inherit;
        text-align: center;
        text-transform: uppercase;
        caret-color: transparent;
      }
      .own {
        display: flex;
        flex-wrap: wrap;
        gap: 0.25rem 1rem;
        align-items: center;
        margin-bottom: 0.75rem;
        font-size: 0.875rem;
      }
      .own label {
        display: flex;
        gap: 0.4rem;
        align-items: center;
      }
      .own p {
        flex-basis: 100%;
        color: var(--soft);
      }
      button {
        padding: 0 1rem;
      }
      dialog > button {
        margin-top: 1rem;
      }
    `,
  ];

  @property({ attribute: false }) texts!: PageTexts;
  /** Whether there is no 3D view. */
  @property({ type: Boolean }) flat = false;
  /** Whether two runs are compared. */
  @property({ type: Boolean }) pair = false;
  @query('dialog') private dialog!: HTMLDialogElement;
  @query('h2') private heading!: HTMLElement;

  toggle(): void {
    if (this.dialog.open) this.dialog.close();
    else {
      this.dialog.showModal();
      this.heading.focus(); // not the button at its end, which may be out of sight
    }
  }

  get open(): boolean {
    return this.dialog.open;
  }

  /** The switch for single-character keys, and the note on reassigning them. */
  private own(): TemplateResult {
    const { ownKeys: say } = this.texts;
    return html`<div class="own">
      <label>
        <input
          class="everywhere"
          type="checkbox"
          .checked=${!keyMap.isOff}
          @change=${() => this.change(() => (keyMap.isOff = !keyMap.isOff))}
        />
        ${say.everywhere}
      </label>
      <button ?disabled=${keyMap.word === ''} @click=${() => this.change(() => keyMap.reset())}>
        ${say.reset}
      </button>
      <p>${say.everywhereHint}. ${say.changeHint}</p>
    </div>`;
  }

  /** A letter is a field in which another one can be typed. */
  private key(name: string, use: string): TemplateResult {
    if (!letters.some((letter) => letter === name)) return html`<kbd>${keyName(name)}</kbd>`;
    return html`<kbd
      ><input
        type="text"
        readonly
        data-key=${name}
        aria-label=${this.texts.ownKeys.change(use)}
        .value=${keyMap.pressed(name)}
        @keydown=${(event: KeyboardEvent) => this.onKey(event, name)}
    /></kbd>`;
  }

  private onKey(event: KeyboardEvent, name: string): void {
    const [, letter] = /^Key([A-Z])$/.exec(event.code) ?? [];
    if (letter === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    this.change(() => keyMap.assign(name, letter));
  }

  private change(change: () => void): void {
    change();
    this.requestUpdate();
    const options = { detail: keyMap.word, bubbles: true, composed: true };
    this.dispatchEvent(new CustomEvent<string>('vidno-keys', options));
  }

  override render(): TemplateResult {
    const { texts } = this;
    const missing = new Set([...only[this.pair ? 'one' : 'pair'], ...(this.flat ? solid : [])]);
    return html`<dialog aria-labelledby="title">
      <h2 id="title" tabindex="-1">${texts.keys}</h2>
      ${this.own()}
      <dl>
        ${keys
          .filter(([use]) => !missing.has(use))
          .map(
            ([use, names]) =>
              html`<div>
                <dt>${names.map((name) => this.key(name, texts.keyMap[use]))}</dt>
                <dd>${texts.keyMap[use]}</dd>
              </div>`,
          )}
      </dl>
      <button @click=${() => this.toggle()}>${texts.close}</button>
    </dialog>`;
  }
}
