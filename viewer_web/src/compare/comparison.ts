import type { Trace } from '../replay/trace.js';
import { Counters } from './counters.js';
import type { Counts } from './counters.js';
import { differenceAt } from './difference.js';
import { Pairing, common } from './pairing.js';
import { Parting } from './parting.js';
import type { Steps } from './parting.js';
import { surveyOf } from './survey.js';

/** The counters of both runs. */
export type CountsOfBoth = readonly [one: Counts, other: Counts];

/** A comparison of two runs. It takes a pass over both, which may be spread over frames. */
export class Comparison {
  /** Null if the methods differ; then no steps are the same. */
  readonly parting: Parting | null;
  private pairing: Pairing | null = null;
  private readonly counters: readonly [Counters, Counters];
  private end: number | null = null;

  constructor(
    readonly one: Trace,
    readonly other: Trace,
  ) {
    const isOneMethod = one.header.method === other.header.method;
    this.parting = isOneMethod ? new Parting(one, other) : null;
    this.counters = [new Counters(one, surveyOf(one)), new Counters(other, surveyOf(other))];
  }

  /**
   * Continues for about this time. Returns whether the comparison is complete, or has to wait until the runs have grown.
   */
  read(milliseconds = Infinity): boolean {
    const end = performance.now() + milliseconds;
    const isRead = [surveyOf(this.one), surveyOf(this.other)].every((survey) =>
      survey.read(end - performance.now()),
    );
    if (!isRead) return false;
    if (this.pairing === null) this.pair();
    return this.parting?.read(end - performance.now()) ?? true;
  }

  private get lengths(): Steps {
    return [this.one.timeline.length, this.other.timeline.length];
  }

  private pair(): void {
    const surveys = [surveyOf(this.one), surveyOf(this.other)] as const;
    if (!surveys[0].complete || !surveys[1].complete) return;
    this.pairing = new Pairing(common(surveys[0].landmarks, surveys[1].landmarks), this.lengths);
    const [last, otherLast] = this.lengths;
    this.end = differenceAt(this.one, last, this.other, otherLast);
  }

  /** The step of the other run beside one of this run; null until it is known. */
  paired(step: number): number | null {
    const { text = null, deed = null } = this.parting ?? {};
    if (deed?.[0] === step) return deed[1];
    const isOneDetail = this.one.header.detail === this.other.header.detail;
    // The texts are the same up to there.
    if (isOneDetail && text && step <= text[0]) return step < text[0] ? step : text[1];
    return this.pairing?.other(step) ?? null;
  }

  /** How the runs are aligned if they have no window, row or curve in common: by progress, if need be from a step on. */
  get alignment(): 'byShare' | 'byShareAfter' | null {
    if (this.pairing?.byShare !== true) return null;
    return (this.parting?.text?.[0] ?? 1) > 1 ? 'byShareAfter' : 'byShare';
  }

  /** How much differs in the end, see `differenceAt`; null until it is known. */
  get differsAtEnd(): number | null {
    return this.end;
  }

  /** The counters up to two steps, or of the whole runs. */
  counts([step, other]: Steps = this.lengths): CountsOfBoth {
    return [this.counters[0].upTo(step), this.counters[1].upTo(other)];
  }
}
