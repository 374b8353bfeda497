import { LitElement, css, html, nothing } from 'lit';
import type { PropertyValues, TemplateResult } from 'lit';
import { customElement, state } from 'lit/decorators.js';
import '../../elements/file-drop.js';
import { headerStyle } from '../../elements/header.style.js';
import '../../elements/languages.js';
import { noticeStyle } from '../../elements/notice.style.js';
import { base, tokens } from '../../elements/theme.js';
import { chartComplaint, chartTexts } from '../../i18n/chart.js';
import { preferredLanguage } from '../../language/language.js';
import type { Language } from '../../language/language.js';
import { isRefusal } from '../../trace/refusal.js';
import { adviceOf } from '../advice.js';
import { adviceText } from '../advice-words.js';
import { formatChoice, parseChoice } from '../choice.js';
import type { Choice } from '../choice.js';
import './choices.js';
import { colors } from './colors.style.js';
import './front-element.js';
import './plot-element.js';
import './replay-element.js';
import './series-element.js';
import type { Chart } from '../format.js';
import type { Point } from '../points.js';
import { embeddedChart, embeddedReplay, readChart } from '../format.js';
import { shownOf } from '../shown.js';
import type { Shown } from '../shown.js';
import { explanation, missingText, sizeText } from '../words.js';

const chartStyle = css`
  :host {
    box-sizing: border-box;
    display: grid;
    min-height: 100dvh;
    padding: 0 0.6rem 0.6rem;
    gap: 0 0.9rem;
    grid-template: 'header' 3.25rem 'choices' auto 'main' auto 'side' auto / minmax(0, 1fr);
    background: var(--paper);
  }
  vidno-choices {
    grid-area: choices;
    padding-bottom: 0.7rem;
  }
  .notice {
    padding-bottom: 0.6rem;
  }
  main {
    grid-area: main;
    display: flex;
    flex-direction: column;
    min-width: 0;
    min-height: 0;
  }
  .alone {
    grid-column: 1 / -1;
  }
  .panel {
    padding: 0.7rem 0.9rem;
    border: 1px solid var(--line);
    border-radius: var(--radius);
    background: var(--panel);
  }
  .plot {
    padding: 0.4rem;
  }
  vidno-plot {
    height: 28rem;
  }
  .about {
    padding: 0.6rem 0.2rem;
    color: var(--soft);
  }
  .about h2 {
    margin: 0;
    font-size: 1em;
    color: var(--ink);
  }
  aside {
    grid-area: side;
    display: flex;
    flex-direction: column;
    gap: 0.75rem;
    min-width: 0;
    min-height: 0;
  }
  .empty {
    display: grid;
    gap: 0.8rem;
    width: min(38rem, 100%);
    margin: 12vh auto 0;
  }
  code {
    display: block;
    padding: 0.6rem 0.8rem;
    border-radius: 6px;
    background: var(--well);
    font-family: var(--mono);
    overflow-wrap: anywhere;
  }
  @media (min-width: 1100px) {
    :host {
      height: 100dvh;
      min-height: 38rem;
      padding: 0 0.9rem 0.9rem;
      grid-template:
        'header header' 3.25rem 'choices choices' auto 'main side' minmax(0, 1fr)
        / minmax(0, 1fr) clamp(23rem, 27vw, 34rem);
    }
    .plot {
      flex: 1;
      min-height: 0;
    }
    vidno-plot {
      height: 100%;
    }
    .about {
      padding-bottom: 0;
    }
    .front {
      flex: 0 1 auto;
      min-height: 8rem;
      overflow: auto;
      scrollbar-width: thin;
    }
  }
  @media (min-width: 1600px) {
    :host {
      font-size: 1.125rem;
    }
  }
`;

/** A file that could not be shown. */
interface Failure {
  readonly name: string;
  readonly error: unknown;
}

/** The page: a chart of the cost and error of each way to make a picture. */
@customElement('vidno-chart')
export class ChartElement extends LitElement {
  static override styles = [tokens, base, noticeStyle, headerStyle, colors, chartStyle];

  @state() private language: Language = 'en';
  @state() private chart: Chart | null = null;
  @state() private choice: Choice = parseChoice('');
  @state() private chosen: Point | null = null;
  @state() private failure: Failure | null = null;
  /** The point chosen last. It stays when the mouse moves on. */
  @state() private picked: Point | null = null;
  private readonly replay = embeddedReplay(document);
  private shown: Shown | null = null;
  private opening = 0;

  override connectedCallback(): void {
    super.connectedCallback();
    this.language = preferredLanguage();
    this.followAddress();
    window.addEventListener('hashchange', this.followAddress);
    try {
      this.chart = embeddedChart(document);
    } catch (error) {
      this.failure = { name: location.pathname.split('/').at(-1) ?? '', error };
    }
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    window.removeEventListener('hashchange', this.followAddress);
  }

  private readonly followAddress = (): void => {
    this.choice = parseChoice(location.hash);
    this.language = this.choice.language ?? this.language;
  };

  private async open(file: File): Promise<void> {
    const turn = ++this.opening;
    try {
      const chart = await readChart(file);
      if (turn !== this.opening) return;
      this.chart = chart;
      this.failure = null;
    } catch (error) {
      if (turn === this.opening) this.failure = { name: file.name, error };
    }
  }

  private choose(choice: Partial<Choice>): void {
    this.choice = { ...this.choice, language: this.language, ...choice };
    this.language = this.choice.language ?? this.language;
    history.replaceState(null, '', formatChoice(this.choice));
  }

  override willUpdate(changed: PropertyValues): void {
    if (!['chart', 'choice', 'language'].some((key) => changed.has(key))) return;
    this.shown = this.chart && shownOf(this.chart, this.choice, this.language);
    this.chosen = null;
    this.picked = null;
  }

  override updated(): void {
    document.documentElement.lang = this.language;
    document.title = `${chartTexts[this.language].tagline} · vidno`;
  }

  override render(): TemplateResult {
    const texts = chartTexts[this.language];
    return html`
      <header>
        <h1>vidno</h1>
        <p class="tagline">${texts.tagline}</p>
        <div class="tools">
          ${this.shown === null ? nothing : this.drop(true)}
          <vidno-languages
            .chosen=${this.language}
            @choose=${({ detail }: CustomEvent<Language>) => this.choose({ language: detail })}
          ></vidno-languages>
        </div>
      </header>
      ${this.shown === null ? this.nothingOpen() : this.page(this.shown)}
    `;
  }

  private page(shown: Shown): TemplateResult {
    const choose = ({ detail }: CustomEvent<Partial<Choice>>): void => this.choose(detail);
    const point = ({ detail }: CustomEvent<Point | null>): void => {
      this.chosen = detail;
      this.picked = detail ?? this.picked;
    };
    return html`
      <vidno-choices .shown=${shown} @choose=${choose}></vidno-choices>
      <main>
        ${this.notice()}
        <div class="panel plot">
          <vidno-plot .shown=${shown} .chosen=${this.chosen} @point=${point}></vidno-plot>
        </div>
        <div class="about">${about(shown)}</div>
      </main>
      <aside>
        <vidno-series class="panel" .shown=${shown} @choose=${choose}></vidno-series>
        ${this.picking(shown)}
        <div class="panel front">
          <vidno-front .shown=${shown} .chosen=${this.chosen} @point=${point}></vidno-front>
        </div>
      </aside>
    `;
  }

  /** The links of a point. There are none if the page of traces is unknown, or the chart does not contain the file. */
  private picking(shown: Shown): TemplateResult | typeof nothing {
    if (this.replay === null || !shown.hasFiles) return nothing;
    return html`<vidno-replay
      class="panel"
      .shown=${shown}
      .point=${this.picked}
      .page=${this.replay}
    ></vidno-replay>`;
  }

  private nothingOpen(): TemplateResult {
    const { empty, howTo } = chartTexts[this.language];
    return html`<main class="alone">
      ${this.notice()}
      <div class="empty">
        <div class="panel">
          <p>${empty} ${howTo}</p>
          <code>vidno chart SCENE... -o chart.html</code>
        </div>
        ${this.drop(false)}
      </div>
    </main>`;
  }

  private drop(compact: boolean): TemplateResult {
    return html`<vidno-file-drop
      accept=".json"
      ?compact=${compact}
      .texts=${chartTexts[this.language]}
      @file=${({ detail }: CustomEvent<File>) => this.open(detail)}
    ></vidno-file-drop>`;
  }

  private notice(): TemplateResult | typeof nothing {
    const { failure, language } = this;
    if (failure === null) return nothing;
    const { name, error } = failure;
    return html`<div class="notice">
      <p class="failed" role="alert">
        ${isRefusal(error) ? chartComplaint(name, error, language) : chartTexts[language].broken(name)}
      </p>
    </div>`;
  }
}

function about(shown: Shown): TemplateResult {
  const { view, texts, cost } = shown;
  const paragraphs = [
    adviceText(adviceOf(view.subjects, cost), shown),
    explanation(shown),
    missingText(shown),
    sizeText(shown),
  ];
  return html`
    <h2>${texts.whichRun}</h2>
    ${paragraphs.map((text) => (text === null ? nothing : html`<p>${text}</p>`))}
  `;
}
