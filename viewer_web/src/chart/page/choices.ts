import { LitElement, css, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { base } from '../../elements/theme.js';
import { kinds } from '../format.js';
import type { Kind } from '../format.js';
import { whole } from '../numbers.js';
import type { Shown } from '../shown.js';
import { nameIn } from '../../language/scene-name.js';
import type { View } from '../subject.js';

/** The choice of the subject and of the two axes. */
@customElement('vidno-choices')
export class ChoicesElement extends LitElement {
  static override styles = [
    base,
    css`
      :host {
        display: flex;
        flex-wrap: wrap;
        gap: 0.5rem 1.25rem;
        align-items: center;
      }
      .scene,
      fieldset {
        display: flex;
        gap: 0.5rem;
        align-items: center;
        min-width: 0;
      }
      .scene > span,
      legend {
        float: left;
        color: var(--soft);
      }
      select {
        min-width: 0;
        max-width: clamp(10rem, 100vw - 65rem, 24rem);
        padding: 0 0.5rem;
      }
      .segments {
        display: flex;
        flex-wrap: wrap;
        gap: 1px;
        overflow: hidden;
        border: 1px solid var(--line);
        border-radius: 6px;
        background: var(--line);
      }
      .segments:has(:focus-visible) {
        outline: 3px solid var(--accent);
        outline-offset: 2px;
      }
      .segments label {
        position: relative;
        flex: auto;
        padding: 0.25rem 0.7rem;
        background: var(--panel);
        text-align: center;
        white-space: nowrap;
      }
      .segments label:has(:checked) {
        background: var(--accent);
        color: var(--on-accent);
      }
      @media (forced-colors: active) {
        .segments label:has(:checked) {
          forced-color-adjust: none;
          background: Highlight;
          color: HighlightText;
        }
      }
      .segments input {
        position: absolute;
        inset: 0;
        width: 100%;
        height: 100%;
        margin: 0;
        opacity: 0;
        cursor: pointer;
      }
      @media (max-width: 640px) {
        .scene,
        fieldset {
          display: block;
          flex: 1 1 100%;
        }
        .scene > span,
        legend {
          float: none;
          font-size: 0.8125em;
        }
        select {
          width: 100%;
          max-width: none;
        }
      }
    `,
  ];

  @property({ attribute: false }) shown!: Shown;

  override render(): TemplateResult {
    const { texts, subjectTexts, axes, cost, error } = this.shown;
    const costTexts = axes.costs.map((id) => [id, texts.costs[id].name] as const);
    const errorTexts = axes.errors.map((id) => [id, texts.errors[id].name] as const);
    return html`
      <label class="scene">
        <span>${subjectTexts.show}</span>
        <select @change=${this.onScene}>
          ${kinds.map((kind) => this.kind(kind))}
        </select>
      </label>
      ${this.segments('cost', texts.cost, costTexts, cost)}
      ${this.segments('error', texts.error, errorTexts, error)}
    `;
  }

  private kind(kind: Kind): TemplateResult | typeof nothing {
    const views = this.shown.views.filter((view) => view.kind === kind);
    if (views.length === 0) return nothing;
    return html`<optgroup label=${this.shown.texts.kinds[kind]}>
      ${views.map((view) => this.option(view))}
    </optgroup>`;
  }

  private option({ id, name, kind, subjects }: View): TemplateResult {
    const { texts, view, language } = this.shown;
    return html`<option value=${id} .selected=${id === view.id}>
      ${name === null ? texts.allOf[kind](whole(subjects.length, language)) : nameIn(language, name)}
    </option>`;
  }

  private segments(
    name: 'cost' | 'error',
    title: string,
    options: readonly (readonly [string, string])[],
    chosen: string,
  ): TemplateResult {
    return html`<fieldset>
      <legend>${title}</legend>
      <div class="segments">
        ${options.map(
          ([id, label]) =>
            html`<label>
              <input
                type="radio"
                name=${name}
                value=${id}
                .checked=${id === chosen}
                @change=${() => this.choose({ [name]: id })}
              />${label}
            </label>`,
        )}
      </div>
    </fieldset>`;
  }

  private onScene(event: Event): void {
    this.choose({ view: (event.target as HTMLSelectElement).value });
  }

  private choose(detail: object): void {
    this.dispatchEvent(new CustomEvent('choose', { detail }));
  }
}
