import { algorithmOf } from '../algorithm/algorithm.js';
import type { Algorithm } from '../algorithm/algorithm.js';
import type { Trace } from '../replay/trace.js';
import { indexFrom } from '../time/goals.js';
import { eventNames } from '../trace/events.js';
import type { Event, EventName } from '../trace/events.js';
import type { Summed } from './counters.js';

const atOnce = 512;

/** A quantity summed up over the events of some names. */
export interface Sum {
  readonly counter: Summed;
  readonly at: readonly EventName[];
  amount(event: Event): number;
}

/** Steps in order, and the sum up to each of them. */
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

/**
 * The data of a run for comparison with another: its landmarks, which are steps that occur at most once in any run, and its
 * sums. Collected in one pass, which may be spread over frames and continues as the run grows.
 */
export class Survey {
  readonly landmarks = new Map<string, number>();
  private readonly algorithm: Algorithm;
  private readonly sums: ReadonlyMap<Summed, Sums>;
  private readonly isLooked: readonly boolean[];
  private seen = 0;
  /** The current window, polygon or curve. */
  private current = '';

  constructor(private readonly trace: Trace) {
    this.algorithm = algorithmOf(trace.header);
    const { sums, landmarks } = this.algorithm;
    this.sums = new Map(sums.map(({ counter }) => [counter, new Sums()]));
    const looked = new Set([...landmarks, ...sums.flatMap(({ at }) => at)]);
    this.isLooked = eventNames.map((name) => looked.has(name));
  }

  /** The sum up to a step, which must have been surveyed; null for other counters. */
  upTo(counter: Summed, step: number): number | null {
    return this.sums.get(counter)?.upTo(step) ?? null;
  }

  /** Whether the whole run was surveyed. */
  get complete(): boolean {
    return this.trace.complete && this.isUpToDate;
  }

  private get isUpToDate(): boolean {
    return this.seen >= this.trace.timeline.length;
  }

  /** Continues for about this time. Returns whether all steps read so far are surveyed. */
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
      if (this.isLooked[name] !== true) continue;
      const event = timeline.event(step);
      if (event !== null) this.look(event, step);
      some++;
    }
  }

  private look(event: Event, step: number): void {
    const { begins, landmark, sums } = this.algorithm;
    const name = landmark(event, this.current);
    if (name !== null && begins.includes(event.e)) this.current = name;
    if (name !== null && !this.landmarks.has(name)) this.landmarks.set(name, step);
    for (const { counter, at, amount } of sums) {
      const found = at.includes(event.e) ? amount(event) : 0;
      if (found > 0) this.sums.get(counter)?.add(step, found);
    }
  }
}

const surveys = new WeakMap<Trace, Survey>();

/** The survey of a run, shared by all its comparisons. */
export function surveyOf(trace: Trace): Survey {
  const survey = surveys.get(trace) ?? new Survey(trace);
  surveys.set(trace, survey);
  return survey;
}
