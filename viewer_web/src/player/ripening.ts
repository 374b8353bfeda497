import type { ReactiveController, ReactiveControllerHost } from 'lit';
import { rest } from '../base/rest.js';
import type { Timeline } from '../replay/timeline.js';
import type { Trace } from '../replay/trace.js';

/** Milliseconds per slice; between two slices the page can respond. */
const atOnce = 6;

/** Prepares quick seeks in a shown run while the page is idle. */
export class Ripening implements ReactiveController {
  private trace: Trace | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(host: ReactiveControllerHost) {
    host.addController(this);
  }

  hostDisconnected(): void {
    clearTimeout(this.timer);
    this.trace = null;
  }

  /** Prepares a run that is completely read. */
  follow(trace: Trace): void {
    const wanted = trace.complete ? trace : null;
    if (wanted === this.trace) return;
    this.trace = wanted;
    clearTimeout(this.timer);
    if (wanted !== null) this.timer = setTimeout(() => this.goOn(wanted.timeline), rest);
  }

  private goOn(timeline: Timeline): void {
    if (timeline.ripen(atOnce)) return;
    this.timer = setTimeout(() => this.goOn(timeline), atOnce);
  }
}
