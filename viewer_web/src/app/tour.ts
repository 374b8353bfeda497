import { LitElement, css, html, nothing } from 'lit';
import type { PropertyValues, TemplateResult } from 'lit';
import { customElement, property, query, state } from 'lit/decorators.js';
import { base } from '../elements/theme.js';
import { texts } from '../i18n/index.js';
import type { Language } from '../language/language.js';

/** CSS pixels between a part of the page and its explanation, and around both. */
const gap = 10;

/**
 * A tour of a few steps through the page. Each step explains one of its parts, beside that part. An event `end` reports the
 * end of the tour.
 */
@customElement('vidno-tour')
export class TourElement extends LitElement {
  static override styles = [
    base,
    css`
      .part,
      section {
        position: fixed;
        z-index: 8;
      }
      .part {
        border: 3px solid var(--accent);
        border-radius: var(--radius);
        pointer-events: none;
      }
      section {
        width: min(22rem, 100vw - 2rem);
        padding: 0.9rem 1rem;
        border: 1px solid var(--accent);
        border-radius: var(--radius);
        background: var(--panel);
        box-shadow: 0 8px 32px rgb(10 12 18 / 35%);
      }
      h2 {
        margin-bottom: 0.3rem;
        color: var(--ink);
        font-size: 1rem;
        letter-spacing: 0;
      }
      footer {
        display: flex;
        gap: 0.5rem;
        align-items: center;
        margin-top: 0.7rem;
      }
      footer span {
        flex: 1;
        color: var(--soft);
        font-size: 0.8125rem;
      }
      button {
        padding: 0 0.8rem;
      }
      .next {
        border-color: var(--accent);
        background: var(--accent);
        color: var(--on-accent);
      }
    `,
  ];

  @property({ attribute: false }) language: Language = 'en';
  /** The parts of the page, in the order of the steps. */
  @property({ attribute: false }) parts: () => readonly (Element | null | undefined)[] = () => [];
  @state() private at = 0;
  @query('section') private card!: HTMLElement;
  @query('.part') private frame!: HTMLElement;
  @query('.next') private button!: HTMLElement;

  override connectedCallback(): void {
    super.connectedCallback();
    window.addEventListener('resize', this.place);
    window.addEventListener('keydown', this.onKey, { capture: true });
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    window.removeEventListener('resize', this.place);
    window.removeEventListener('keydown', this.onKey, { capture: true });
  }

  override updated(changed: PropertyValues): void {
    this.place();
    if (changed.has('at')) this.button.focus();
  }

  override render(): TemplateResult {
    const { tour } = texts[this.language];
    const { at } = this;
    const step = tour.steps[at];
    const isLast = at === tour.steps.length - 1;
    return html`<div class="part"></div>
      <section role="dialog" aria-labelledby="title" aria-describedby="text">
        <h2 id="title">${step?.title}</h2>
        <p id="text">${step?.text}</p>
        <footer>
          <span>${tour.at(at + 1, tour.steps.length)}</span>
          ${isLast ? nothing : html`<button @click=${() => this.end()}>${tour.leave}</button>`}
          <button class="next" @click=${() => (isLast ? this.end() : this.at++)}>
            ${isLast ? tour.done : tour.next}
          </button>
        </footer>
      </section>`;
  }

  /** Places the explanation beside the part, or over it if there is no room. */
  private readonly place = (): void => {
    const part = this.parts()[this.at];
    part?.scrollIntoView({ block: 'nearest' });
    const { left, top, right, bottom, width, height } =
      part?.getBoundingClientRect() ?? new DOMRect(gap, gap);
    Object.assign(this.frame.style, {
      left: `${left}px`,
      top: `${top}px`,
      width: `${width}px`,
      height: `${height}px`,
    });
    const card = this.card.getBoundingClientRect();
    const [x, y] =
      right + gap + card.width < innerWidth
        ? [right + gap, top]
        : left - gap - card.width > 0
          ? [left - gap - card.width, top]
          : top - gap - card.height > 0
            ? [left, top - gap - card.height]
            : [left + gap, bottom - gap - card.height];
    this.card.style.left = `${Math.max(gap, Math.min(x, innerWidth - card.width - gap))}px`;
    this.card.style.top = `${Math.max(gap, Math.min(y, innerHeight - card.height - gap))}px`;
  };

  private readonly onKey = (event: KeyboardEvent): void => {
    if (event.key !== 'Escape') return;
    event.preventDefault();
    this.end();
  };

  private end(): void {
    this.dispatchEvent(new CustomEvent('end'));
  }
}
