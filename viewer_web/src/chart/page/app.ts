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
import { formatChoice, parseChoice } from '../choice.js';
import type { Choice } from '../choice.js';
import './advice-element.js';
import './choices.js';
import { colors } from './colors.style.js';
import './panel-element.js';
import './plot-element.js';
import './points-element.js';
import './subject-element.js';
import type { Chart } from '../format.js';
import type { Point } from '../points.js';
import { settingId } from '../series.js';
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
    grid-template: 'header' 3.25rem 'main' auto 'side' auto / minmax(0, 1fr);
    background: var(--paper);
  }
  .question {
    display: flex;
    flex-wrap: wrap;
    gap: 0.2rem 1.2rem;
    align-items: center;
    justify-content: space-between;
    padding-bottom: 0.5rem;
  }
  vidno-choices {
    padding-top: 0.7rem;
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
    height: 32rem;
  }
  h2 {
    font-size: 1.375rem;
    color: var(--ink);
  }
  .about {
    padding: 0.6rem 0.2rem;
    color: var(--soft);
  }
  summary {
    cursor: pointer;
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
        'header header' 3.25rem 'main side' minmax(0, 1fr)
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
    aside {
      overflow: auto;
      scrollbar-width: thin;
    }
  }
  @media (min-width: 1600px) {
    :host {
      font-size: 1.125rem;
    }
  }
  @media print {
    :host {
      display: block;
      height: auto;
    }
    header,
    vidno-choices,
    vidno-subject,
    vidno-panel,
    vidno-points,
    .about {
      display: none;
    }
    .panel {
      padding: 0;
      border: 0;
    }
    vidno-plot {
      height: auto;
    }
    vidno-advice {
      width: 12cm;
      margin-top: 0.5cm;
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
    document.title = `${chartTexts[this.language].question} · vidno`;
  }

  override render(): TemplateResult {
    return html`
      <header>
        <h1>vidno</h1>
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
      const id = detail && settingId(detail.setting);
      this.chosen = shown.visible.find(({ setting }) => settingId(setting) === id) ?? null;
      this.picked = this.chosen ?? this.picked;
    };
    return html`
      <main>
        ${this.notice()}
        <div class="question">
          <h2>${shown.texts.question}</h2>
          <vidno-subject .shown=${shown} @choose=${choose}></vidno-subject>
        </div>
        <div class="panel plot">
          <vidno-plot .shown=${shown} .chosen=${this.chosen} @point=${point}></vidno-plot>
        </div>
        <vidno-choices .shown=${shown} @choose=${choose}></vidno-choices>
        <details class="about">${about(shown)}</details>
      </main>
      <aside>
        <vidno-advice class="panel" .shown=${shown} @point=${point}></vidno-advice>
        <vidno-panel
          class="panel"
          .shown=${shown}
          .point=${this.picked ?? cheapestOf(shown)}
          .page=${this.replay}
        ></vidno-panel>
        <vidno-points
          class="panel"
          .shown=${shown}
          .chosen=${this.chosen}
          @point=${point}
        ></vidno-points>
      </aside>
    `;
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
      @files=${({ detail: [file] }: CustomEvent<readonly [File]>) => this.open(file)}
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

/** The cheapest right run, as the axes show it. */
function cheapestOf({ answer, main }: Shown): Point | null {
  const id = answer.cheapest && settingId(answer.cheapest.setting);
  return main.find(({ setting }) => settingId(setting) === id) ?? null;
}

function about(shown: Shown): TemplateResult {
  const paragraphs = [explanation(shown), missingText(shown), sizeText(shown)];
  return html`
    <summary>${shown.texts.about}</summary>
    ${paragraphs.map((text) => (text === null ? nothing : html`<p>${text}</p>`))}
  `;
}
