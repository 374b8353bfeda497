import { css, html, nothing } from 'lit';
import type { PropertyValues, TemplateResult } from 'lit';
import { customElement, property, query, queryAll, state } from 'lit/decorators.js';
import { viewOf } from '../algorithm/view.js';
import type { Choice, View } from '../algorithm/view.js';
import type { Editing } from '../editor/editor.js';
import { announcerStyle } from '../elements/announcer.js';
import type { Actions } from '../elements/keyboard.js';
import { ReadOn } from '../elements/read-on.js';
import { base, hiddenStyle, leastPanel, leastPicture, tokens } from '../elements/theme.js';
import { historyOf } from '../history/history.js';
import type { History } from '../history/history.js';
import type { Layer } from '../picture/layers.js';
import { askForLayer } from '../picture/layers-element.js';
import { isOther } from '../picture/pixel.js';
import type { Pixel } from '../picture/pixel.js';
import { Pointing } from '../player/pointing.js';
import { presenterStyle } from '../player/presenter.style.js';
import { StageElement } from '../player/stage-element.js';
import type { Pixels } from '../replay/screen.js';
import type { Line } from '../replay/values.js';
import type { Trace } from '../replay/trace.js';
import { marked } from '../time/bookmarks.js';
import type { Bookmarks } from '../time/bookmarks.js';
import type { Deviation } from '../trace/editions.js';
import type { TravelElement } from '../time/travel.js';
import './broken-line.js';
import './compared-run.js';
import type { ComparedRunElement } from './compared-run.js';
import { Comparison } from './comparison.js';
import './comparison-facts.js';
import type { Switch } from './comparison-facts.js';
import { pairActions } from './comparison-keys.js';
import { differenceAt, pictureAt } from './difference.js';
import type { Steps } from './parting.js';

/** The pictures are beside each other in the middle, each with its listing on its outer side. */
const comparisonStyle = css`
  :host {
    display: flex;
    flex-direction: column;
    gap: 0.6rem;
    min-height: 0;
    container-type: inline-size;
    --legend: none;
    --least-picture: ${leastPicture};
  }
  /* For a projector everything is magnified, so less is large enough. */
  :host([presenting]) {
    --tools: none;
    --least-picture: 8rem;
  }
  .runs {
    display: grid;
    flex: 1 0 auto;
    gap: 0.5rem 0.6rem;
    grid-template:
      'name-one name-one name-other name-other' auto
      'list-one picture-one picture-other list-other' minmax(min-content, var(--panels, 1fr))
      'said-one said-one said-other said-other' auto
      'facts facts facts facts' auto
      / minmax(0, 1fr) minmax(${leastPanel}, 1fr) minmax(${leastPanel}, 1fr) minmax(0, 1fr);
  }
  vidno-comparison-facts {
    grid-area: facts;
  }
  /* Where there is little room, the pictures and sentences are more important. */
  @media (max-height: 799px) {
    vidno-broken-line {
      --what: none;
      --changes: none;
    }
  }
  /* Where the page scrolls, the time controls stay in sight. */
  .dock {
    position: sticky;
    bottom: 0;
    z-index: 1;
    flex: none;
    padding: 0.5rem 0.9rem 0.6rem;
    border: 1px solid var(--line);
    border-radius: var(--radius);
    background: var(--panel);
  }
  @container (min-width: 1500px) {
    .runs {
      --said: 3.6rem;
      --said-size: 1.1875rem;
    }
  }
  @container (max-width: 1100px) {
    .runs {
      gap: 0.4rem 0.6rem;
      grid-template:
        'name-one name-other' auto
        'picture-one picture-other' minmax(${leastPanel}, var(--panels, 1fr))
        'said-one said-other' auto
        'list-one list-other' clamp(6.5rem, 100dvh - 41.5rem, 24rem)
        'facts facts' auto
        / minmax(0, 1fr) minmax(0, 1fr);
    }
  }
  @container (max-width: 960px) {
    .runs {
      --name-width: 100%;
      --said: 5.2rem;
      --said-size: 0.9375rem;
      flex: none;
      grid-template:
        'name-one name-other' auto
        'picture-one picture-other' max(${leastPanel}, 50cqw)
        'said-one said-other' auto
        'facts facts' auto
        'list-one list-other' 24rem
        / minmax(0, 1fr) minmax(0, 1fr);
    }
  }
  /* Two pictures beside each other do not fit. */
  @container (max-width: 650px) {
    .runs {
      --name-width: auto;
      --name-size: 0.8125rem;
      --said: 3.9rem;
      --said-size: 0.875rem;
      gap: 0.4rem;
      grid-template:
        'name-one' auto
        'picture-one' ${leastPanel}
        'said-one' auto
        'name-other' auto
        'picture-other' ${leastPanel}
        'said-other' auto
        'facts' auto
        'list-one' 15rem
        'list-other' 15rem
        / minmax(0, 1fr);
    }
    .dock {
      padding: 0.4rem 0.6rem;
    }
    vidno-broken-line {
      --changes: none;
    }
  }
  :host([presenting]) vidno-broken-line {
    --what: none;
    --changes: none;
    --ways: none;
  }
  :host([presenting]) .runs {
    --listing: none;
    --name-width: 100%;
    --name-size: 0.8125rem;
    --said: 5.4rem;
    --said-size: 1.0625rem;
    flex: 1;
    min-height: 0;
    grid-template:
      'name-one name-other' auto
      'picture-one picture-other' minmax(0, 1fr)
      'said-one said-other' auto
      / minmax(0, 1fr) minmax(0, 1fr);
  }
  :host([presenting]) :is(vidno-comparison-facts, vidno-transport) {
    display: none;
  }
  :host([presenting]) .dock {
    display: flex;
    padding: 0 0 0.3rem;
    border: 0;
    background: none;
  }
  /* A sticky dock would hide the pictures. */
  @media (max-height: 599px) {
    .dock {
      position: static;
    }
  }
  /* One sheet, A4. */
  @media print {
    :host {
      container-type: normal;
      --tools: none;
    }
    .runs {
      --said: 20mm;
      flex: 1;
      grid-template:
        'name-one name-other' auto
        'picture-one picture-other' 88mm
        'said-one said-other' auto
        'facts facts' auto
        'list-one list-other' minmax(0, 1fr)
        / minmax(0, 1fr) minmax(0, 1fr);
    }
    .dock {
      display: none;
    }
  }
`;

const mostPerFrame = 8;

/** One of the two runs at its step, with the other run's picture to compare with. */
interface Half {
  readonly side: 'one' | 'other';
  readonly trace: Trace;
  readonly view: View;
  readonly against: Pixels | null;
}

/** What a run has drawn at a step: pixels, or lines if those are to be marked. */
interface Beside {
  readonly picture: Pixels | null;
  readonly lines: readonly Line[];
}

/**
 * Two runs side by side. The controls step the first run, and the other one follows. Events carry each step of the first
 * run (`vidno-step`), each chosen pixel (`vidno-pixel`) and changed bookmarks (`vidno-bookmarks`); `vidno-layer` asks to
 * mark the pixels that differ.
 */
@customElement('vidno-comparison')
export class ComparisonElement extends StageElement {
  static override styles = [
    tokens,
    base,
    hiddenStyle,
    presenterStyle,
    comparisonStyle,
    announcerStyle,
  ];

  /** The other run, and the number of its steps read so far. */
  @property({ attribute: false }) rival: Trace | null = null;
  @property({ attribute: false }) rivalLength = 0;
  /** A description of the other run, if its header does not suffice. */
  @property({ attribute: false }) rivalNote = '';
  @property({ attribute: false, hasChanged: isOther }) pixel: Pixel | null = null;
  @property({ attribute: false }) layer: Layer = 'picture';
  @property({ attribute: false }) editing: Editing | null = null;
  /** How the other run is broken, if that is the only difference. */
  @property({ attribute: false }) broken: Deviation | null = null;
  /** The title of the smallest scene that shows it, if that scene is shown. */
  @property({ attribute: false }) smallest: string | null = null;
  /** Whether lines of the first run can be broken. */
  @property({ type: Boolean }) breakable = false;
  /**
   * Whether to go to the first difference once it is known. An event `vidno-sought` reports that it was found, or that
   * there is none.
   */
  @property({ type: Boolean }) seeks = false;
  @state() private linked = true;
  /** Whether the corners of the scene can be dragged in the first picture. */
  @state() isEdited = false;
  @state() private otherStep = 0;
  @query('vidno-travel') readonly travel!: TravelElement;
  @queryAll('vidno-compared-run') readonly runs!: NodeListOf<ComparedRunElement>;
  private comparison: Comparison | null = null;
  private halves: readonly [Half, Half] | null = null;
  private history: History | null = null;
  /** The number of pixels or columns that differ now. */
  private differs: number | null = null;
  private readonly pointing = new Pointing(this);
  private readonly reader = new ReadOn(this, mostPerFrame);

  override willUpdate(changed: PropertyValues<this>): void {
    super.willUpdate(changed);
    const { trace, rival } = this;
    if (trace === null || rival === null) return;
    if (this.comparison?.one !== trace || this.comparison.other !== rival) {
      this.comparison = new Comparison(trace, rival);
    }
    if (changed.has('trace') || changed.has('pixel')) this.history = historyOf(trace, this.pixel);
    this.reader.read(this);
    this.pair(this.comparison, rival);
    this.halves = this.look(trace, rival);
  }

  override updated(changed: PropertyValues<this>): void {
    super.updated(changed);
    if (this.seeks) this.seek();
  }

  private seek(): void {
    const parting = this.comparison?.parting ?? null;
    if (parting === null || (parting.text === null && !parting.complete)) return;
    if (parting.text !== null) this.moveTo(parting.text[0]);
    this.dispatchEvent(new CustomEvent('vidno-sought'));
  }

  protected override actions(event: KeyboardEvent): Actions {
    return pairActions(this, event);
  }

  /** Continues the work that needs a pass over the runs. */
  read(milliseconds: number): boolean {
    const isRead = this.comparison?.read(milliseconds) !== false;
    return (this.history?.read(milliseconds) ?? true) && isRead;
  }

  private pair(comparison: Comparison, { timeline }: Trace): void {
    const step = this.linked ? (comparison.paired(this.step) ?? this.otherStep) : this.otherStep;
    this.otherStep = Math.min(Math.max(0, Math.trunc(step) || 0), timeline.length);
  }

  private look(trace: Trace, rival: Trace): readonly [Half, Half] {
    const { pixel, language } = this;
    const { step, otherStep } = this;
    const choice: Choice = { language, pixel, pointed: this.pointing.at };
    this.differs = differenceAt(trace, step, rival, otherStep);
    const against = this.beside(rival, otherStep);
    const back = this.beside(trace, step);
    const [view, other] = [viewOf(trace, step, choice), viewOf(rival, otherStep, choice)];
    return [
      { side: 'one', trace, view: { ...view, rival: against.lines }, against: against.picture },
      { side: 'other', trace: rival, view: { ...other, rival: back.lines }, against: back.picture },
    ];
  }

  /** What a run has drawn, for comparison with the other one. */
  private beside(run: Trace, step: number): Beside {
    if (this.differs === null) return { picture: null, lines: [] };
    const isOfCurves = run.header.scene.curves !== null;
    return {
      picture: isOfCurves ? null : pictureAt(run, step),
      lines: isOfCurves && this.isMarked ? run.timeline.linesAt(step) : [],
    };
  }

  private get isMarked(): boolean {
    return this.layer === 'difference';
  }

  override render(): TemplateResult | typeof nothing {
    const { comparison, halves } = this;
    if (comparison === null || halves === null) return nothing;
    const [{ view, trace }, other] = halves;
    const check = this.checkOf(trace);
    const steps: Steps = [view.step, other.view.step];
    return html`
      ${this.broken === null ? nothing : this.brokenLine(comparison, this.broken)}
      <div class="runs" @pointerover=${this.pointing.onOver} @pointerleave=${this.pointing.onLeave}>
        ${halves.map((half) => this.half(half))}
        <vidno-comparison-facts
          .comparison=${comparison}
          .steps=${steps}
          .differs=${this.differs}
          .on=${this.switches}
          ?editable=${this.editing !== null}
          .language=${view.language}
          @go=${({ detail }: CustomEvent<number>) => this.moveTo(detail)}
          @switch=${({ detail }: CustomEvent<Switch>) => this.toggle(detail)}
        ></vidno-comparison-facts>
      </div>
      <div class="dock">
        ${this.announcer.render()} ${this.playControls(view, check, this.history)}
        ${this.presenter.corner(view)}
      </div>
      ${this.presenter.cover()}
      <vidno-keys .texts=${view.texts} pair @vidno-keys=${() => this.requestUpdate()}></vidno-keys>
    `;
  }

  private brokenLine(comparison: Comparison, broken: Deviation): TemplateResult {
    const tell = ({ type }: Event): unknown =>
      this.dispatchEvent(new CustomEvent<string>('vidno-broken', { detail: type }));
    return html`<vidno-broken-line
      .deviation=${broken}
      .comparison=${comparison}
      .language=${this.language}
      .smallest=${this.smallest}
      .atEnd=${comparison.differsAtEnd}
      .text=${comparison.parting?.text ?? null}
      ?complete=${comparison.parting?.complete === true}
      @go=${({ detail }: CustomEvent<number>) => this.moveTo(detail)}
      @smallest=${tell}
      @own=${tell}
      @back=${tell}
    ></vidno-broken-line>`;
  }

  private half({ side, trace, view, against }: Half): TemplateResult {
    const isOne = side === 'one';
    return html`<vidno-compared-run
      class=${side}
      .trace=${trace}
      .view=${view}
      .layer=${this.isMarked ? 'difference' : 'picture'}
      .against=${against}
      .editing=${isOne && this.isEdited ? this.editing : null}
      .note=${isOne ? '' : this.rivalNote}
      ?alone=${!isOne && !this.linked}
      ?playing=${this.clock.playing}
      ?breakable=${isOne && this.breakable}
      @pixel=${({ detail }: CustomEvent<Pixel>) => this.choosePixel(detail)}
      @step=${({ detail }: CustomEvent<number>) => (this.otherStep = detail)}
    ></vidno-compared-run>`;
  }

  private choosePixel(pixel: Pixel): void {
    this.pixel = pixel;
    this.dispatchEvent(new CustomEvent('vidno-pixel', { detail: pixel }));
  }

  private get switches(): ReadonlySet<Switch> {
    const { linked, isEdited, isMarked } = this;
    const all = { together: linked, edit: isEdited, mark: isMarked };
    return new Set((Object.keys(all) as Switch[]).filter((name) => all[name]));
  }

  toggle(name: Switch): void {
    if (name === 'together') this.linked = !this.linked;
    else if (name === 'edit') this.isEdited = !this.isEdited;
    else askForLayer(this, this.isMarked ? 'picture' : 'difference');
  }

  /** Points at the next or previous thing of the first run's step. */
  point(by: 1 | -1): void {
    if (this.halves) this.pointing.move(by, this.halves[0].view);
  }

  goToParting(what: 'text' | 'deed'): void {
    const found = this.comparison?.parting?.[what];
    if (found) this.moveTo(found[0]);
  }

  /** Bookmarks the first run's step. */
  bookmark(): void {
    const detail = marked(this.bookmarks, this.step);
    this.dispatchEvent(new CustomEvent<Bookmarks>('vidno-bookmarks', { detail }));
  }
}

declare global {
  interface HTMLElementTagNameMap {
    'vidno-comparison': ComparisonElement;
  }
}
