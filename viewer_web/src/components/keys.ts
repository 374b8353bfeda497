import { LitElement, css, html } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property, query } from 'lit/decorators.js';
import type { KeyUse, PageTexts } from '../i18n/texts.js';
import { dialogStyle } from './dialog.style.js';
import { base } from './theme.js';

const keys: readonly (readonly [use: KeyUse, keys: readonly string[]])[] = [
  ['step', ['←', '→']],
  ['ten', ['Shift ←', 'Shift →']],
  ['over', ['[', ']']],
  ['out', ['Shift [', 'Shift ]']],
  ['goal', [',', '.']],
  ['ends', ['Home', 'End']],
  ['play', ['Space']],
  ['speed', ['−', '+']],
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
  ['exact', ['X']],
  ['solid', ['V']],
  ['turn', ['← ↑ ↓ →', '+', '−', '0']],
  ['edit', ['E']],
  ['draw', ['N']],
  ['undo', ['Ctrl Z', 'Ctrl Y']],
  ['corner', ['← ↑ ↓ →', 'PgUp', 'PgDn', '+', 'Del']],
  ['present', ['F']],
  ['remote', ['PgDn', 'PgUp', 'B', '.', 'Esc']],
  ['compare', ['D']],
  ['parting', ['J', 'Shift J']],
  ['save', ['S', 'Shift S']],
  ['reader', ['R']],
  ['map', ['?']],
];

/** What there is only where a run is alone, and only where it is compared. */
const only: Readonly<Record<'one' | 'pair', ReadonlySet<KeyUse>>> = {
  one: new Set(['layer', 'predict', 'answer', 'bookmarks', 'exact', 'solid', 'turn', 'reader']),
  pair: new Set(['mark', 'parting']),
};

/** What there is only where there is something to be seen in 3D. */
const solid: readonly KeyUse[] = ['solid', 'turn'];

/** The map of keys. */
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
      button {
        margin-top: 1rem;
        padding: 0 1rem;
      }
    `,
  ];

  @property({ attribute: false }) texts!: PageTexts;
  /** Whether there is nothing to be seen in 3D. */
  @property({ type: Boolean }) flat = false;
  /** Whether two runs are compared. */
  @property({ type: Boolean }) pair = false;
  @query('dialog') private dialog!: HTMLDialogElement;
  @query('h2') private heading!: HTMLElement;

  toggle(): void {
    if (this.dialog.open) this.dialog.close();
    else {
      this.dialog.showModal();
      this.heading.focus(); // and not the button at its end, which may be out of sight
    }
  }

  get open(): boolean {
    return this.dialog.open;
  }

  override render(): TemplateResult {
    const { texts } = this;
    const missing = new Set([...only[this.pair ? 'one' : 'pair'], ...(this.flat ? solid : [])]);
    return html`<dialog aria-labelledby="title">
      <h2 id="title" tabindex="-1">${texts.keys}</h2>
      <dl>
        ${keys
          .filter(([use]) => !missing.has(use))
          .map(
            ([use, names]) =>
              html`<div>
                <dt>${names.map((name) => html`<kbd>${name}</kbd>`)}</dt>
                <dd>${texts.keyMap[use]}</dd>
              </div>`,
          )}
      </dl>
      <button @click=${() => this.toggle()}>${texts.close}</button>
    </dialog>`;
  }
}
