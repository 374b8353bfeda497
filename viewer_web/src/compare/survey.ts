import { changesAel, indexFrom } from '../time/goals.js';
import { eventNames } from '../trace/events.js';
import type { Event, EventName } from '../trace/events.js';
import type { Trace } from '../replay/trace.js';
import { cells } from '../language/words.js';

const atOnce = 512;

const looked: readonly EventName[] = [
  'pop',
  'decide',
  'polygon',
  'scanline',
  'ael_add',
  'ael_drop',
  'fill',
  'draw',
  'span',
  'curve',
  'visibility',
  'paint',
];
const isLooked = eventNames.map((name) => looked.includes(name));

/** Steps in order, and how much there was of something up to each of them. */
class Sums {
  private readonly steps: number[] = [];
  private readonly sums: number[] = [];

  add(step: number, amount = 1): void {
    this.sums.push((this.sums.at(-1) ?? 0) + amount);
    this.steps.push(step);
  }

  upTo(step: number): number {
    return this.sums[indexFrom(this.steps, step + 1) - 1] ?? 0;
  }
}

/** How many pixels an event gives a colour. */
function painted(event: Event): number {
  if (event.e === 'fill') return event.rect[2] * event.rect[3];
  return event.e === 'draw' || event.e === 'span' || event.e === 'paint' ? cells(event.runs) : 0;
}

/**
 * What can be said of a run beside another one: its landmarks, steps that any run has at most once and by which it can be
 * held against others, and how often what happens. One pass, which may be spread over frames and goes on as the run grows.
 */
export class Survey {
  readonly landmarks = new Map<string, number>();
  readonly splits = new Sums();
  readonly ael = new Sums();
  readonly painted = new Sums();
  private seen = 0;
  /** The window, the polygon or the curve in hand. */
  private inHand = '';

  constructor(private readonly trace: Trace) {}

  /** Whether the whole run was seen. */
  get complete(): boolean {
    return this.trace.complete && this.isUpToDate;
  }

  private get isUpToDate(): boolean {
    return this.seen >= this.trace.timeline.length;
  }

  /** Goes on for about so long; says whether all that is there was seen. */
  read(milliseconds = Infinity): boolean {
    const end = performance.now() + milliseconds;
    while (!this.isUpToDate && performance.now() < end) this.readSome();
    return this.isUpToDate;
  }

  private readSome(): void {
    const { timeline } = this.trace;
    const { names } = timeline;
    for (let some = 0; some < atOnce && this.seen < names.length;) {
      const step = ++this.seen;
      const name = names[step - 1] ?? 0;
      if (isLooked[name] !== true) continue;
      const event = timeline.event(step);
      if (event !== null) this.look(event, step);
      some++;
    }
  }

  private look(event: Event, step: number): void {
    const landmark = this.landmarkOf(event);
    if (landmark !== null && !this.landmarks.has(landmark)) this.landmarks.set(landmark, step);
    if (event.e === 'decide' && event.case === 'split') this.splits.add(step);
    if (changesAel(event)) this.ael.add(step);
    const pixels = painted(event);
    if (pixels > 0) this.painted.add(step, pixels);
  }

  /** The name of a step; null for one that any run may have more than once. */
  private landmarkOf(event: Event): string | null {
    if (event.e === 'pop') return (this.inHand = `window ${event.window.join()}`);
    if (event.e === 'decide') return `decide ${this.inHand}`;
    if (event.e === 'polygon') return (this.inHand = `polygon ${event.polygon}`);
    if (event.e === 'curve') return (this.inHand = `curve ${event.curve}`);
    if (event.e === 'visibility') return `column ${event.x} ${this.inHand}`;
    return event.e === 'scanline' ? `row ${event.row} ${this.inHand}` : null;
  }
}

const surveys = new WeakMap<Trace, Survey>();

/** A run is surveyed once, whatever it is held against. */
export function surveyOf(trace: Trace): Survey {
  const survey = surveys.get(trace) ?? new Survey(trace);
  surveys.set(trace, survey);
  return survey;
}
