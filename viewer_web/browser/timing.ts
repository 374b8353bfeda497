import type { CDPSession, Page } from 'playwright-core';

/** Milliseconds of processor time on the page's main thread, and of these in style and in layout. */
export interface Cost {
  readonly task: number;
  readonly style: number;
  readonly layout: number;
}

/** The times of one event, in milliseconds. */
export interface Measured {
  /** Until the frame that shows the result is drawn. */
  readonly drawn: number;
  /** Until the following frame begins: two frames at 60 per second, if the page keeps up. */
  readonly next: number;
  readonly cost: Cost;
}

const partOf: Readonly<Record<string, keyof Cost>> = {
  TaskDuration: 'task',
  RecalcStyleDuration: 'style',
  LayoutDuration: 'layout',
};

type Noted = Window & { noted: Promise<{ drawn: number; next: number }>; trace: unknown };

/**
 * Measures the processor time of events, which other programs on the machine affect less, and the time until the page has
 * drawn the result.
 */
export class Meter {
  private constructor(
    private readonly page: Page,
    private readonly session: CDPSession,
  ) {}

  static async of(page: Page): Promise<Meter> {
    const session = await page.context().newCDPSession(page);
    await session.send('Performance.enable', { timeDomain: 'threadTicks' });
    return new Meter(page, session);
  }

  private async spent(): Promise<Cost> {
    const { metrics } = await this.session.send('Performance.getMetrics');
    const cost = { task: 0, style: 0, layout: 0 };
    for (const { name, value } of metrics) {
      const part = partOf[name];
      if (part !== undefined) cost[part] = 1000 * value;
    }
    return cost;
  }

  /** Runs an action that presses a key or moves the mouse. After a move the page is to show another run. */
  async measure(what: 'keydown' | 'pointermove', act: () => Promise<void>): Promise<Measured> {
    // An event may arrive at any time between two frames.
    await this.page.waitForTimeout(Math.random() * 17);
    await this.page.evaluate(note, what);
    const before = await this.spent();
    await act();
    const { drawn, next } = await this.page.evaluate(() => (window as unknown as Noted).noted);
    const after = await this.spent();
    const cost = {
      task: after.task - before.task,
      style: after.style - before.style,
      layout: after.layout - before.layout,
    };
    return { drawn, next, cost };
  }
}

/** Runs in the page: records when the frame of the next event is drawn, and when the following frame begins. */
function note(what: 'keydown' | 'pointermove'): void {
  const noted = window as unknown as Noted;
  const player = document.querySelector('vidno-app')?.shadowRoot?.querySelector('vidno-player');
  const { trace } = player ?? { trace: null };
  noted.noted = new Promise((resolve) => {
    const onEvent = (event: Event): void => {
      // The browser delivers a move at the beginning of a frame, at whatever time it was made.
      const start = what === 'keydown' ? event.timeStamp : performance.now();
      const onFrame = (): void => {
        if (what === 'pointermove' && player?.trace === trace) {
          requestAnimationFrame(onFrame);
          return;
        }
        const since = (): number => performance.now() - start;
        const { port1, port2 } = new MessageChannel();
        const drawn = new Promise<number>((done) => (port1.onmessage = () => done(since())));
        const next = new Promise<number>((done) => requestAnimationFrame(() => done(since())));
        // A message posted in a frame arrives after its style, layout and paint.
        port2.postMessage(null);
        void Promise.all([drawn, next]).then((times) => {
          port1.close();
          resolve({ drawn: times[0], next: times[1] });
        });
      };
      requestAnimationFrame(onFrame);
    };
    window.addEventListener(what, onEvent, { capture: true, once: true });
  });
}

/** The smallest value with at least this share of the values at or below it. */
function quantile(values: readonly number[], part: number): number {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.max(0, Math.ceil(part * sorted.length) - 1)] ?? NaN;
}

export const median = (values: readonly number[]): number => quantile(values, 0.5);

/** The median and the 95th percentile. */
const spread = (values: readonly number[]): string =>
  `${median(values).toFixed(1)} (p95 ${quantile(values, 0.95).toFixed(1)})`;

/** The figures of the events, each as its median and 95th percentile. */
export function told(all: readonly Measured[]): string {
  const of = (figure: (each: Measured) => number): string => spread(all.map(figure));
  return (
    `drawn ${of(({ drawn }) => drawn)} ms, next frame ${of(({ next }) => next)} ms, ` +
    `main thread ${of(({ cost }) => cost.task)} ms, ` +
    `of which style ${of(({ cost }) => cost.style)} ms, layout ${of(({ cost }) => cost.layout)} ms`
  );
}
