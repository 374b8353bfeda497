import { html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement } from 'lit/decorators.js';
import { live } from 'lit/directives/live.js';
import { texts } from '../i18n/index.js';
import { kernels, methodNames, offeredNames, runs } from '../run/options.js';
import { resize } from '../run/sketch.js';
import { details } from '../trace/events.js';
import { FormElement } from './form.js';
import { formStyle } from '../elements/form.style.js';
import { base } from '../elements/theme.js';

type Choice = 'method' | 'kernel' | 'edition' | 'detail';
type Names = Readonly<Record<string, string>>;

/** The settings of the run, and the area of the scene. */
@customElement('vidno-run-form')
export class RunFormElement extends FormElement {
  static override styles = [base, formStyle];

  override render(): TemplateResult {
    const { say, editing } = this;
    const { methods, editions } = texts[this.language].page;
    const levels = Object.fromEntries(details.map((level) => [level, say.details[level]]));
    return html`
      <section>
        <h3>${say.run}</h3>
        <div class="fields">
          ${this.select('method', methodNames(methods, editing.options))}
          ${this.select('edition', offeredNames(editing.options, editions))}
          ${this.select('kernel', this.kernelNames())} ${this.select('detail', levels)}
        </div>
        <p class="rule">${texts[this.language].family.rules[editing.options.method]}</p>
        <label class="line">
          <input
            type="checkbox"
            name="check"
            .checked=${editing.options.check}
            @change=${(event: Event) =>
              this.choose({ check: (event.target as HTMLInputElement).checked })}
          />
          ${say.check}
        </label>
      </section>
      ${this.area()}
    `;
  }

  private kernelNames(): Names {
    const { options } = this.editing;
    const offered = kernels.filter((kernel) => runs({ ...options, kernel }));
    return Object.fromEntries([...offered, options.kernel].map((name) => [name, name]));
  }

  private select(field: Choice, names: Names): TemplateResult {
    const chosen = this.editing.options[field];
    return html`<label class=${field}>
      <span>${this.say[field]}</span>
      <select
        name=${field}
        .value=${live(chosen)}
        @change=${(event: Event) =>
          this.choose({ [field]: (event.target as HTMLSelectElement).value })}
      >
        ${Object.entries(names).map(
          ([value, name]) =>
            html`<option value=${value} ?selected=${value === chosen}>${name}</option>`,
        )}
      </select>
    </label>`;
  }

  private choose(options: Readonly<Record<string, unknown>>): void {
    this.act({ do: 'options', options: options });
  }

  private area(): TemplateResult {
    const { say, editing } = this;
    const { area, background } = editing.sketch;
    return html`<section>
      <h3>${say.area}</h3>
      <div class="fields four">
        ${(['x', 'y', 'width', 'height'] as const).map(
          (field) =>
            html`<label>
              <span>${say.areaFields[field]}</span>
              <input
                type="number"
                name=${field}
                .value=${live(String(area[field]))}
                @change=${(event: Event) =>
                  this.number(event, (value) =>
                    this.edit((old) => resize(old, { ...old.area, [field]: value })),
                  )}
              />
            </label>`,
        )}
      </div>
      ${editing.sketch.curves === null ? this.background(background) : nothing}
    </section>`;
  }

  private background(background: string): TemplateResult {
    const { say } = this;
    return html`<label class="line">
      <input
        type="color"
        .value=${background}
        @input=${(event: Event) =>
          this.color(event, 'background', (color) => (old) => ({ ...old, background: color }))}
      />
      ${say.background}
    </label>`;
  }
}
