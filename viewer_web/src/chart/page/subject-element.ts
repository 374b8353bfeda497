import { LitElement, css, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { base } from '../../elements/theme.js';
import { nameIn } from '../../language/scene-name.js';
import { kinds } from '../format.js';
import type { Kind } from '../format.js';
import { whole } from '../numbers.js';
import type { Shown } from '../shown.js';
import type { View } from '../subject.js';
import { selectStyle } from './select.style.js';

/** The choice of the scene or surface. */
@customElement('vidno-subject')
export class SubjectElement extends LitElement {
  static override styles = [
    base,
    selectStyle,
    css`
      :host {
        display: block;
        min-width: 0;
      }
    `,
  ];

  @property({ attribute: false }) shown!: Shown;

  override render(): TemplateResult {
    return html`<label class="choice">
      <span>${this.shown.subjectTexts.show}</span>
      <select name="view" @change=${this.onChange}>
        ${kinds.map((kind) => this.kind(kind))}
      </select>
    </label>`;
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

  private onChange(event: Event): void {
    const { value: view } = event.target as HTMLSelectElement;
    this.dispatchEvent(new CustomEvent('choose', { detail: { view } }));
  }
}
