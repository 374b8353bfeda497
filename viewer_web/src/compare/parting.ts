import type { Timeline } from '../replay/timeline.js';
import { details, eventNames, kinds } from '../trace/events.js';
import type { Detail, EventName } from '../trace/events.js';
import type { Trace } from '../replay/trace.js';
import { sameDeed } from './deed.js';

/** A step of each of two runs. */
export type Steps = readonly [one: number, other: number];

const atOnce = 256;

/**
 * Of each number of a name whether both runs tell such an event: one of them may be less detailed, and then lacks some of
 * the calls, or not be checked.
 */
function toldByBoth(one: Detail, other: Detail): readonly boolean[] {
  const least = Math.min(details.indexOf(one), details.indexOf(other));
  const untold: readonly EventName[] = one === other ? ['disagree'] : ['disagree', 'call'];
  return eventNames.map(
    (name) => !untold.includes(name) && details.indexOf(kinds[name].from) <= least,
  );
}

/** Events are only looked into where their texts differ. */
function doSame(a: Timeline, one: number, b: Timeline, other: number): boolean {
  if (a.line(one) === b.line(other)) return true;
  const [did, didOther] = [a.event(one), b.event(other)];
  return did !== null && didOther !== null && sameDeed(did, didOther);
}

/**
 * The steps at which two runs of one method part: the first event that is written otherwise, if only by the last digit of
 * a number, and the first that does something else. Looked for in one pass, which may be spread over frames.
 */
export class Parting {
  /** Null as long as no such step was found. */
  text: Steps | null = null;
  deed: Steps | null = null;
  /** The steps that were compared: up to where the texts part they are the same, thereafter they do the same. */
  private seen: Steps = [0, 0];
  private isOver = false;
  private readonly told: readonly boolean[];

  constructor(
    private readonly one: Trace,
    private readonly other: Trace,
  ) {
    this.told = toldByBoth(one.header.detail, other.header.detail);
  }

  /** Whether all is known that there is to be known. */
  get complete(): boolean {
    return this.isOver || this.deed !== null;
  }

  /** Goes on for about so long; says whether it is complete, or has to wait until the runs have grown. */
  read(milliseconds = Infinity): boolean {
    const end = performance.now() + milliseconds;
    let goesOn = true;
    while (goesOn && performance.now() < end) goesOn = this.readSome();
    return !goesOn;
  }

  private readSome(): boolean {
    for (let i = 0; i < atOnce; i++) {
      if (!(this.text === null ? this.readText() : this.readDeed())) return false;
    }
    return true;
  }

  /** Compares the next step of both as it is written; says whether there is more to compare. */
  private readText(): boolean {
    const [a, b] = [this.one.timeline, this.other.timeline];
    const step = this.seen[0] + 1;
    if (step > a.length || step > b.length) {
      if (!this.areWhole) return false;
      if (a.length === b.length) this.isOver = true;
      else this.text = [Math.min(step, a.length), Math.min(step, b.length)];
    } else if (a.line(step) !== b.line(step)) this.text = [step, step];
    else this.seen = [step, step];
    return !this.isOver;
  }

  /** Compares what the next step that both tell does; says whether there is more to compare. */
  private readDeed(): boolean {
    const [a, b] = [this.one.timeline, this.other.timeline];
    const [one, other] = [this.next(a.names, this.seen[0]), this.next(b.names, this.seen[1])];
    const areOver = [one > a.length, other > b.length] as const;
    if (areOver[0] || areOver[1]) {
      if (!this.areWhole) return false;
      this.isOver = true;
      if (areOver[0] !== areOver[1])
        this.deed = [Math.min(one, a.length), Math.min(other, b.length)];
    } else if (doSame(a, one, b, other)) this.seen = [one, other];
    else this.deed = [one, other];
    return !this.complete;
  }

  private get areWhole(): boolean {
    return this.one.complete && this.other.complete;
  }

  /** The next step that both tell. */
  private next(names: Uint8Array, after: number): number {
    let step = after + 1;
    while (step <= names.length && this.told[names[step - 1] ?? 0] === false) step++;
    return step;
  }
}
