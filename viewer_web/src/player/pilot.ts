import { html, nothing } from 'lit';
import type { ReactiveController, ReactiveControllerHost, TemplateResult } from 'lit';
import { texts } from '../i18n/index.js';
import type { Language } from '../language/language.js';
import type { Trace } from '../replay/trace.js';

/** Milliseconds of a frame for a long seek. */
const mostPerFrame = 30;
/** Milliseconds until the first message about it, and between two messages. */
const patience = 300;

/** The goal of a seek, the number of steps to it at first, and the number left now. */
interface Way {
  readonly to: number;
  readonly whole: number;
  left: number;
}

/** Carries out seeks to distant steps. Meanwhile the last reached step is shown, and the page remains responsive. */
export class Pilot implements ReactiveController {
  /** The step that is shown. */
  reached = 0;
  /** Resolved when the host has reached its step. */
  arrival: Promise<void> = Promise.resolve();
  private trace: Trace | null = null;
  private way: Way | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private told = 0;
  private arrive = (): void => undefined;

  constructor(
    private readonly host: ReactiveControllerHost,
    /** Called with the current step when the reader cancels. */
    private readonly stay: (step: number) => void,
  ) {
    host.addController(this);
  }

  hostDisconnected(): void {
    this.end();
  }

  get isUnderWay(): boolean {
    return this.way !== null;
  }

  /** Starts a seek to a step of a run; returns the step to show now. */
  follow(trace: Trace, step: number): number {
    if (trace !== this.trace) {
      this.trace = trace;
      this.reached = 0;
      this.end();
    }
    if (this.way?.to === step) return this.reached;
    const left = trace.timeline.approach(step, mostPerFrame);
    if (left === 0) {
      this.end();
      this.reached = step;
    } else this.begin({ to: step, whole: left, left });
    return this.reached;
  }

  cancel(): void {
    this.end();
    this.stay(this.reached);
  }

  /** A message about the seek, if it takes a while. */
  render(language: Language): TemplateResult | typeof nothing {
    const { way } = this;
    if (way === null || this.told === 0) return nothing;
    const { onTheWay, cancel } = texts[language].page;
    const percent = Math.floor((100 * (way.whole - way.left)) / way.whole);
    return html`<p class="on-the-way">
      <span role="status">${onTheWay(way.to.toLocaleString(language))}</span>
      <progress max="100" value=${percent}></progress>
      <button @click=${() => this.cancel()}>${cancel}</button>
    </p>`;
  }

  private begin(way: Way): void {
    if (this.way === null) this.arrival = new Promise((resolve) => (this.arrive = resolve));
    this.way = way;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.goOn(way, performance.now() + patience));
  }

  private goOn(way: Way, due: number): void {
    way.left = this.trace?.timeline.approach(way.to, mostPerFrame) ?? 0;
    const now = performance.now();
    const isDue = now >= due;
    if (way.left === 0) {
      this.end();
      this.host.requestUpdate();
      return;
    }
    if (isDue) {
      this.told = now;
      this.host.requestUpdate();
    }
    this.timer = setTimeout(() => this.goOn(way, isDue ? now + patience : due));
  }

  private end(): void {
    clearTimeout(this.timer);
    this.way = null;
    this.told = 0;
    this.arrive();
  }
}
