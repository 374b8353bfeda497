import { algorithmOf } from '../algorithm/algorithm.js';
import { isIn } from '../picture/pixel.js';
import type { Pixel } from '../picture/pixel.js';
import type { Trace } from '../replay/trace.js';
import type { Entry, Watch } from './entry.js';

const atOnce = 4096;

/**
 * All steps that concern a pixel, or a column of a run of curves, in order. They are collected in one pass over the events,
 * which a page may spread over several frames. Nothing is stored for other pixels.
 */
export class History {
  private readonly found: Entry[] = [];
  private readonly watch: Watch;
  private seen = 0;
  private last: Entry | null = null;

  constructor(
    readonly trace: Trace,
    readonly pixel: Pixel,
  ) {
    this.watch = algorithmOf(trace.header).watch(pixel, trace);
  }

  get entries(): readonly Entry[] {
    return this.found;
  }

  /** The entry that painted the pixel last. */
  get painter(): Entry | null {
    return this.last;
  }

  /** Whether the whole trace was searched. */
  get complete(): boolean {
    return this.trace.complete && this.isUpToDate;
  }

  private get isUpToDate(): boolean {
    return this.seen >= this.trace.timeline.length;
  }

  /** Continues for about this time. Returns whether all events read so far were searched. */
  read(milliseconds = Infinity): boolean {
    const end = performance.now() + milliseconds;
    do this.readSome();
    while (!this.isUpToDate && performance.now() < end);
    return this.isUpToDate;
  }

  private readSome(): void {
    const { timeline } = this.trace;
    const end = Math.min(this.seen + atOnce, timeline.length);
    const { names } = timeline;
    for (; this.seen < end; this.seen++) {
      if (this.watch.wanted[names[this.seen] ?? 0] === true) this.see(this.seen + 1);
    }
  }

  private see(step: number): void {
    const { timeline } = this.trace;
    if (this.watch.isElsewhere?.(timeline.line(step)) === true) return;
    const event = timeline.event(step);
    const outcome = event && this.watch.see(event, step);
    if (event === null || outcome === null) return;
    const entry = { step, event, outcome, known: this.watch.known };
    this.found.push(entry);
    if (outcome === 'paint') this.last = entry;
  }

  /** The index of the last entry at a step or before it, or -1. */
  indexAt(step: number): number {
    let from = 0;
    let end = this.found.length;
    while (from < end) {
      const middle = (from + end) >> 1;
      if ((this.found[middle]?.step ?? Infinity) <= step) from = middle + 1;
      else end = middle;
    }
    return from - 1;
  }
}

/** The history of a pixel of a trace; null for a pixel outside the picture. */
export function historyOf(trace: Trace | null, pixel: Pixel | null): History | null {
  if (trace === null || pixel === null || !isIn(pixel, trace.header.scene.area)) return null;
  return new History(trace, pixel);
}
