import { LitElement, css, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property, state } from 'lit/decorators.js';
import { numbersOf } from '../algorithm/view.js';
import type { View } from '../algorithm/view.js';
import { panelsStyle } from '../elements/panels.style.js';
import { base } from '../elements/theme.js';
import { texts } from '../i18n/index.js';
import type { ExactTexts } from '../language/texts.js';
import { superscript } from '../language/words.js';
import type { Trace } from '../replay/trace.js';
import type { SaidDecision } from '../trace/event-table.js';
import './findings-element.js';
import './lens.js';
import { mappedDecisionOf } from './mapped-decision.js';
import type { MappedDecision } from './mapped-decision.js';
import { side } from './places.js';
import type { SignMap, SignMapSource } from './sign-map.js';
import { askCheck, decisionBy } from './truth.js';
import type { Check } from './truth.js';

/** The numbers of a decision, and the map beside or under them. */
const exactnessStyle = css`
  dl {
    display: grid;
    grid-template-columns: auto minmax(0, 1fr);
    gap: 0.2rem 0.9rem;
    align-content: start;
    min-height: 3.95rem;
  }
  dt,
  dd {
    font-size: 0.8125rem;
    line-height: 1.45;
  }
  dd {
    white-space: normal;
    overflow-wrap: anywhere;
  }
  dd.words {
    font-family: inherit;
  }
  .hint {
    color: var(--soft);
    font-size: 0.8125rem;
  }
  .verdict {
    margin-top: 0.5rem;
    padding: 0.3rem 0.5rem;
    border-radius: 5px;
    background: var(--well);
  }
  .verdict.wrong {
    background: var(--bad-wash);
    color: var(--bad);
  }
  .verdict.right {
    color: var(--good);
  }
  button {
    margin-top: 0.5rem;
    padding: 0 0.8rem;
  }
  :host([bare]) {
    flex-direction: row;
  }
  :host([bare]) section {
    flex: 1;
    border: 0;
  }
  :host([bare]) section + section {
    flex: 1.5;
  }
  vidno-lens {
    display: block;
    max-width: 26rem;
    margin-top: 0.4rem;
  }
  :host([bare]) vidno-lens {
    max-width: 9rem;
  }
  @media print {
    :host {
      flex-direction: row;
    }
    section {
      flex: 1;
    }
    section + section {
      border: 0;
    }
    button {
      display: none;
    }
    vidno-lens {
      max-width: 13rem;
    }
  }
  .lines {
    margin: 0;
    padding: 0;
    list-style: none;
    font-family: var(--mono, ui-monospace, monospace);
    font-size: 0.75rem;
    line-height: 1.5;
    overflow-wrap: anywhere;
  }
`;

/** A map, and its decision. */
interface Drawn {
  readonly mapped: MappedDecision;
  readonly map: SignMap;
}

/** The most characters that are shown of a number. Fractions may be longer. */
const longest = 60;
const longestLine = 160;

/** A run with more steps is checked only on request, because that takes seconds. */
const longestAtOnce = 200_000;

/** The decision of the step: its numbers, the right answer, and the answers of the same decision at neighbouring points. */
@customElement('vidno-exactness')
export class ExactnessElement extends LitElement {
  static override styles = [base, panelsStyle, exactnessStyle];

  @property({ attribute: false }) view!: View;
  @property({ attribute: false }) trace!: Trace;
  /** The library that draws maps; null if the page has none. */
  @property({ attribute: false }) maps: SignMapSource | null = null;
  /** How the right answers are known. */
  @property({ attribute: false }) check!: Check;
  /** In a presentation the map is beside the numbers, because nobody scrolls there. */
  @property({ type: Boolean, reflect: true }) bare = false;
  /** The last map with its decision. It stays while another one is drawn. */
  @state() private drawn: Drawn | null = null;
  @state() private isDrawing = false;
  private mapped: MappedDecision | null = null;

  private get texts(): ExactTexts {
    return texts[this.view.language].exact;
  }

  override willUpdate(): void {
    const { trace, view } = this;
    const mapped = mappedDecisionOf(trace, view.step);
    if (JSON.stringify(mapped) === JSON.stringify(this.mapped)) return;
    this.mapped = mapped;
    if (mapped === null || !isAlike(mapped, this.drawn)) this.drawn = null;
    this.isDrawing = mapped !== null && this.maps !== null;
    if (mapped !== null && this.maps !== null) void this.ask(mapped, this.maps);
  }

  /** An open panel starts the check of a run that is not too long. */
  override updated(): void {
    const { check, maps, trace, view } = this;
    const isShort = view.length <= longestAtOnce;
    const isWanted = check.is === 'unchecked' || check.findings === undefined;
    if (isWanted && check.is !== 'checking' && maps !== null && trace.complete && isShort) {
      askCheck(this);
    }
  }

  private async ask(mapped: MappedDecision, maps: SignMapSource): Promise<void> {
    const map = await maps.of(mapped, this.trace.header.kernel);
    if (this.mapped !== mapped) return;
    this.drawn = map && { mapped, map };
    this.isDrawing = false;
  }

  override render(): TemplateResult {
    const { mapped } = this;
    const decision = decisionBy(this.check, this.trace, this.view.step, this.view.language);
    if (decision === null && mapped === null) {
      return html`${this.checked()}
        <section><p class="hint">${this.texts.nothing} ${this.hintOfWrong()}</p></section>
        ${this.list()}`;
    }
    return html`
      ${this.checked()} ${decision && this.decision(decision)}
      ${mapped === null ? this.noLens(this.texts.noLens) : this.lens(mapped, decision)}
      ${this.list()}
    `;
  }

  private list(): TemplateResult | typeof nothing {
    const { findings } = this.check;
    if (findings === undefined) return nothing;
    return html`<vidno-findings .view=${this.view} .findings=${findings}></vidno-findings>`;
  }

  /** Whether the run was checked, and how, if the trace does not say so. */
  private checked(): TemplateResult | typeof nothing {
    const { check, texts: say } = this;
    if (check.is === 'checked' || check.is === 'certain') return nothing;
    const words = this.sayCheck(check);
    const offers = check.is === 'unchecked' && this.maps !== null;
    return html`<section class="checked">
      <p class="hint" role="status">${words}</p>
      ${
        offers
          ? html`<button class="check" @click=${() => askCheck(this)}>${say.check}</button>`
          : nothing
      }
    </section>`;
  }

  private sayCheck(check: Check): string {
    const { texts: say } = this;
    if (check.is === 'checking') return say.checking;
    if (check.is === 'found') {
      const wrong = check.truth.wrong.length;
      const isCorrected = this.view.header.edition === 'corrected';
      return wrong === 0 && !isCorrected ? say.foundNoneBut : say.found(wrong);
    }
    if (check.is === 'unable') return `${say.unable[check.why]} ${check.messages}`;
    return this.maps === null ? `${say.unchecked} ${this.noLibrary}` : say.unchecked;
  }

  private get noLibrary(): string {
    return texts[this.view.language].compare.noLibrary;
  }

  private hintOfWrong(): string {
    const { check } = this;
    const isKnown =
      check.is === 'checked' || (check.is === 'found' && check.truth.wrong.length > 0);
    return isKnown ? this.texts.findWrong : '';
  }

  private decision(decision: SaidDecision): TemplateResult {
    const { title, numbers, answers, judged, judgement, calculations } = decision;
    return html`<section>
        <h3>${title}</h3>
        <dl>
          ${numbers.map(
            ([name, value]) =>
              html`<dt>${name}</dt>
                <dd title=${value}>${written(value)}</dd>`,
          )}
          ${answers.map(
            ([name, answer]) =>
              html`<dt>${name}</dt>
                <dd class="words">${answer}</dd>`,
          )}
        </dl>
        <p class="verdict ${judged}">${judgement}</p>
      </section>
      ${calculations.length === 0 ? nothing : this.byHand(calculations)}`;
  }

  /** The calculation line by line, also with the numbers of the run if they are not the right ones. */
  private byHand(calculations: SaidDecision['calculations']): TemplateResult {
    return html`<section class="by-hand">
      ${calculations.map(
        ({ title, lines }) =>
          html`<h3>${title}</h3>
            <ol class="lines">
              ${lines.map((line) => html`<li title=${line}>${written(line, longestLine)}</li>`)}
            </ol>`,
      )}
    </section>`;
  }

  private lens({ at }: MappedDecision, decision: SaidDecision | null): TemplateResult {
    const say = this.texts;
    const { drawn, isDrawing } = this;
    if (this.maps === null) return this.noLens(this.noLibrary);
    if (drawn !== null) return this.map(drawn, isDrawing ? null : decision);
    if (!isDrawing) return this.noLens(say.noLens);
    return html`<section>
      <h3>${say.lens(numbersOf(this.view).point(at))}</h3>
      <p class="hint">${say.drawing}</p>
    </section>`;
  }

  private map({ mapped, map }: Drawn, decision: SaidDecision | null): TemplateResult {
    const say = this.texts;
    const { at, places, asked } = mapped;
    const title = say.lens(numbersOf(this.view).point(at));
    return html`<section aria-busy=${this.isDrawing ? 'true' : 'false'}>
      <h3>${title}</h3>
      <p class="hint">${say.apart(power(places.step))}</p>
      <p class="hint">${say.wrongPlaces(map.wrong, side ** 2)}</p>
      <vidno-lens
        .map=${map}
        .texts=${say}
        .label=${title}
        ?plain=${!('orientation' in asked)}
      ></vidno-lens>
      ${this.driftOf(map, decision)}
    </section>`;
  }

  /** A note on drift: the Z-buffer accumulates depths and the map does not, so its centre may differ from the run. */
  private driftOf(map: SignMap, decision: SaidDecision | null): TemplateResult | typeof nothing {
    const isOther =
      typeof decision?.taken === 'boolean' &&
      decision.of === 'nearer' &&
      decision.taken !== (map.centre.computed === 1);
    return isOther ? html`<p class="hint">${this.texts.drifted}</p>` : nothing;
  }

  private noLens(why: string): TemplateResult {
    return html`<section><p class="hint">${why}</p></section>`;
  }
}

/** Whether a map has the same kind of decision. */
function isAlike({ asked }: MappedDecision, drawn: Drawn | null): boolean {
  return drawn !== null && Object.keys(asked).join() === Object.keys(drawn.mapped.asked).join();
}

/** A number with all its digits, so that the last bit is visible. */
function written(text: string, most = longest): string {
  return text.length > most ? `${text.slice(0, most)}…` : text;
}

/** A power of two, written as one. */
function power(value: number): string {
  return `2${superscript(Math.log2(value))}`;
}
