import type { Language } from '../language/language.js';
import { languages } from '../language/language.js';
import { isIn } from '../picture/pixel.js';
import type { Pixel } from '../picture/pixel.js';
import type { Trace } from '../replay/trace.js';
import { engine } from '../replay/engine.js';
import { outcomes } from './entry.js';
import type { Entry } from './entry.js';
import type { AtPixel, Holding, Reason } from './reason.js';

const atOnce = 512;

const forgotten = new FinalizationRegistry((history: number) =>
  engine().exports.history_close(history),
);

/**
 * All steps that concern a pixel, or a column of a run of curves, in order. The library collects them in one pass over the
 * events, which a page may spread over several frames. Nothing is stored for other pixels.
 */
export class History {
  private readonly found: Entry[] = [];
  private readonly number: number;
  private seen = 0;
  private last: Entry | null = null;
  private readonly known = new Map<string, Reason>();

  constructor(
    readonly trace: Trace,
    readonly pixel: Pixel,
  ) {
    this.number = engine().exports.history_open(trace.number, ...pixel);
    forgotten.register(this, this.number);
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
    this.seen = Math.min(this.seen + atOnce, timeline.length);
    engine().exports.history_read(this.number, this.seen);
    for (const made of JSON.parse(engine().made()) as readonly Omit<Entry, 'event'>[]) {
      const event = timeline.event(made.step);
      if (event === null) continue;
      const entry = { ...made, event };
      this.found.push(entry);
      if (made.outcome === 'paint') this.last = entry;
    }
  }

  /** An entry in one sentence: that of its step, or for a polygon that missed the pixel only that fact. */
  sentence({ step, outcome }: Entry, language: Language): string {
    const { exports } = engine();
    const place = languages.indexOf(language);
    exports.history_sentence(this.number, step, outcomes.indexOf(outcome), place);
    return engine().made();
  }

  /** Why the pixel has, or after step `now` will have, the colour of this entry, the last one to paint it. */
  why({ step }: Entry, language: Language, now = step): string {
    const isLater = step > now ? 1 : 0;
    engine().exports.history_why(this.number, step, isLater, languages.indexOf(language));
    return engine().made();
  }

  /** The polygons that hold the pixel's centre; null where the picture does not follow the picture rule. */
  holding(): Holding | null {
    engine().exports.history_holding(this.number);
    const made = engine().made();
    return made === '' ? null : (JSON.parse(made) as Holding);
  }

  /** Why the polygon with this place in the scene shows at the pixel or not; for null, that no polygon shows. */
  reason(polygon: number | null, language: Language): Reason {
    const key = `${polygon ?? ''} ${language}`;
    const reason = this.known.get(key) ?? this.makeReason(polygon ?? -1, language);
    this.known.set(key, reason);
    return reason;
  }

  private makeReason(polygon: number, language: Language): Reason {
    engine().exports.history_reason(this.number, polygon, languages.indexOf(language));
    const made = engine().made();
    const end = made.indexOf('\n'); // an id may contain another one
    return { said: made.slice(end + 1), at: JSON.parse(made.slice(0, end)) as AtPixel | null };
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
