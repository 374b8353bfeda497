import { css, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement } from 'lit/decorators.js';
import { live } from 'lit/directives/live.js';
import { firstFormula, withFormula, withoutTolerance } from '../run/surface.js';
import type { Formula } from '../run/surface.js';
import { texts } from '../i18n/index.js';
import type { SurfaceTexts } from '../language/texts.js';
import { FormElement } from '../editor/form.js';
import { formStyle } from '../elements/form.style.js';
import { base } from '../elements/theme.js';

const surfaceFormStyle = css`
  .function {
    display: flex;
    gap: 0.4rem;
    align-items: center;
    font-family: var(--mono);
  }
  .function input {
    flex: 1;
    min-width: 0;
    min-height: 2rem;
    padding: 0 0.4rem;
    border: 1px solid var(--line);
    border-radius: 6px;
    background: var(--panel);
    font-family: var(--mono);
    font-size: 0.8125rem;
  }
  .hint {
    margin: 0.2rem 0 0.4rem;
    color: var(--soft);
    font-size: 0.6875rem;
  }
  fieldset {
    margin: 0.5rem 0 0;
  }
  legend {
    color: var(--soft);
    font-size: 0.75rem;
    font-weight: 600;
  }
  .by-function {
    margin-top: 0.4rem;
    padding: 0 0.55rem;
  }
`;

type Range = 'x' | 'z';
type Way = 'origin' | 'across' | 'back';
const ranges: readonly Range[] = ['x', 'z'];
const ways: readonly Way[] = ['origin', 'across', 'back'];

/** The form of a surface: its function, how curves are cut out of it and seen, or the number of its samples. */
@customElement('vidno-surface-form')
export class SurfaceFormElement extends FormElement {
  static override styles = [base, formStyle, surfaceFormStyle];

  private get words(): SurfaceTexts {
    return texts[this.language].curves.surface;
  }

  override render(): TemplateResult {
    const { formula } = this.editing.sketch;
    return formula === undefined ? this.samples() : this.function(formula);
  }

  private samples(): TemplateResult {
    const { words } = this;
    const curves = this.editing.sketch.curves ?? [];
    const count = curves.reduce((sum, curve) => sum + curve.length, 0);
    return html`<section>
      <h3>${words.title}</h3>
      <p>${words.sampled(curves.length, count)}</p>
      <button
        class="by-function"
        @click=${() => this.edit((old) => ({ ...old, formula: firstFormula(old) }))}
      >
        ${words.give}
      </button>
    </section>`;
  }

  private function(formula: Formula): TemplateResult {
    const { words } = this;
    return html`<section>
      <h3>${words.title}</h3>
      <label class="function">
        <span>y =</span>
        <input
          name="function"
          spellcheck="false"
          autocomplete="off"
          maxlength="500"
          aria-label=${words.function}
          .value=${live(formula.function)}
          @change=${({ target }: Event) =>
            this.change({ function: (target as HTMLInputElement).value })}
        />
      </label>
      <p class="hint">${words.language}</p>
      <div class="fields four">
        ${ranges.flatMap((name) =>
          words.ends[name].map((label, i) =>
            this.field(`${name}${i}`, label, formula[name][i], (value) => ({
              [name]: replaced(formula[name], i, value),
            })),
          ),
        )}
        ${this.field('curves', words.curves, formula.curves, (curves) => ({ curves }))}
        ${this.field('samples', words.samples, formula.samples, (samples) => ({ samples }))}
        ${this.tolerance(formula)}
        ${this.field('up', words.up, formula.view.up, (up) => ({ view: { ...formula.view, up } }))}
      </div>
      ${ways.map((way) => this.way(way, formula))}
    </section>`;
  }

  private way(way: Way, { view }: Formula): TemplateResult {
    const { words } = this;
    return html`<fieldset>
      <legend>${words.ways[way]}</legend>
      <div class="fields">
        ${words.place.map((label, i) =>
          this.field(`${way}${i}`, label, view[way][i], (value) => ({
            view: { ...view, [way]: replaced(view[way], i, value) },
          })),
        )}
      </div>
    </fieldset>`;
  }

  private tolerance({ tolerance }: Formula): TemplateResult {
    const { words } = this;
    return html`<label title=${words.toleranceHint}>
      <span>${words.tolerance}</span>
      <input
        type="number"
        name="tolerance"
        step="any"
        min="0"
        .value=${live(tolerance === undefined ? '' : String(tolerance))}
        @change=${({ target }: Event) => {
          const value = (target as HTMLInputElement).valueAsNumber;
          if (value > 0) this.change({ tolerance: value });
          else this.edit(withoutTolerance);
          this.requestUpdate();
        }}
      />
    </label>`;
  }

  private field(
    name: string,
    label: string,
    value: number | undefined,
    change: (value: number) => Partial<Formula>,
  ): TemplateResult | typeof nothing {
    return html`<label>
      <span>${label}</span>
      <input
        type="number"
        step="any"
        name=${name}
        .value=${live(String(value ?? ''))}
        @change=${(event: Event) => this.number(event, (typed) => this.change(change(typed)))}
      />
    </label>`;
  }

  private change(part: Partial<Formula>): void {
    this.edit((old) => withFormula(old, part));
  }
}

const replaced = (
  [first, second]: readonly [number, number],
  i: number,
  by: number,
): readonly [number, number] => (i === 0 ? [by, second] : [first, by]);
