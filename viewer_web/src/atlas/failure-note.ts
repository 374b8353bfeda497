import { LitElement, css, html, nothing } from 'lit';
import type { TemplateResult } from 'lit';
import { customElement, property } from 'lit/decorators.js';
import { base } from '../elements/theme.js';
import { texts } from '../i18n/index.js';
import type { AtlasTexts } from '../language/texts.js';
import type { Language } from '../language/language.js';
import type { Failure } from '../run/failures.js';
import type { Entry } from './entries.js';

/**
 * A note on the open failure: its effect, its place, why its picture has no proof, and the remedy. Events carry requests:
 * `go` to the step, `compare` to switch the comparison with the correct run, `forget` to close the note.
 */
@customElement('vidno-failure-note')
export class FailureNoteElement extends LitElement {
  static override styles = [
    base,
    css`
      :host {
        display: flex;
        flex: none;
        flex-wrap: wrap;
        gap: 0.4rem 1.5rem;
        align-items: center;
        margin-bottom: 0.5rem;
        padding: 0.5rem 0.75rem;
        border: 1px solid var(--line);
        border-radius: var(--radius);
        background: var(--panel);
        font-size: 0.8125rem;
      }
      p + p {
        margin-top: 0.2rem;
      }
      .there {
        color: var(--bad);
        font-weight: 600;
      }
      .facts {
        flex: 1 1 22rem;
        overflow-wrap: anywhere;
      }
      .unproved {
        margin: 0.2rem 0;
      }
      summary {
        width: fit-content;
        color: var(--accent);
        cursor: pointer;
      }
      .tools {
        display: flex;
        flex-wrap: wrap;
        gap: 0.4rem;
      }
      button {
        min-height: 1.75rem;
        padding: 0 0.6rem;
        font-size: 0.8125rem;
      }
      button[aria-pressed='true'] {
        border-color: var(--accent);
        background: var(--accent-wash);
      }
      @media print {
        .tools {
          display: none;
        }
      }
    `,
  ];

  @property({ attribute: false }) failure!: Failure;
  /** Why its picture has no proof, if the atlas says so. */
  @property({ attribute: false }) unproved: Entry['unproved'] = null;
  @property({ attribute: false }) language: Language = 'en';
  /** Whether the failing run is shown unchanged. After a change it may not be wrong at that step. */
  @property({ type: Boolean }) there = false;
  /** Whether the correct run is beside the failing one. */
  @property({ type: Boolean }) comparing = false;

  override render(): TemplateResult {
    const { failure, unproved, language, comparing } = this;
    const say = texts[language].atlas;
    const { why, remedy, source } = failure;
    const step = this.there ? failure.step : null;
    return html`<div class="facts">
        <p class="why">${why[language]}${source === '' ? nothing : html` (${source})`}</p>
        ${this.there ? this.seen(say) : nothing}
        ${
          this.there && unproved !== null
            ? html`<details class="unproved">
                <summary>${say.unproved}</summary>
                <p>${unproved[language]}</p>
              </details>`
            : nothing
        }
        <p class="remedy">${say.remedy}: ${remedy[language]}</p>
      </div>
      <p class="tools">
        ${
          step === null
            ? nothing
            : html`<button name="go" @click=${() => this.tell('go')}>${say.goTo}</button>`
        }
        <button
          name="compare"
          aria-pressed=${comparing ? 'true' : 'false'}
          @click=${() => this.tell('compare')}
        >
          ${comparing ? say.leave : say.compare}
        </button>
        <button name="forget" @click=${() => this.tell('forget')}>${say.forget}</button>
      </p>`;
  }

  private seen(say: AtlasTexts): TemplateResult {
    const { language } = this;
    const { there, step } = this.failure;
    const text = there[language];
    return html`<p class="there">
      ${step === null ? text : say.at(step.toLocaleString(language), text)}
    </p>`;
  }

  private tell(what: 'go' | 'compare' | 'forget'): void {
    this.dispatchEvent(new CustomEvent(what));
  }
}
