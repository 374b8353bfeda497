import { details, eventNames, kinds } from '../trace/events.js';
import type { Detail } from '../trace/events.js';
import type { Trace } from '../trace/trace.js';
import { sameDeed } from './deed.js';

/** A step of each of two runs. */
export type Steps = readonly [one: number, other: number];

const atOnce = 256;

/** Of each number of a name whether both runs tell such an event: one of them may be less detailed, or not checked. */
function toldByBoth(...levels: readonly Detail[]): readonly boolean[] {
  const least = Math.min(...levels.map((level) => details.indexOf(level)));
  return eventNames.map(
    (name) => name !== 'disagree' && details.indexOf(kinds[name].from) <= least,
  );
}

/**
 * The steps at which two runs of one method part: the first event that is written otherwise, if only by the last digit of
 * a number, and the first that does something else. Looked for in one pass, which may be spread over frames.
 */
export class Parting {
  /** Null as long as no such step was found. */
  text: Steps | null = null;
  deed: Steps | null = null;
  /** The steps that were compared. */
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
    const names = [this.one.timeline.names, this.other.timeline.names] as const;
    for (let i = 0; i < atOnce; i++) {
      const next: Steps = [this.next(names[0], this.seen[0]), this.next(names[1], this.seen[1])];
      const isEnd = [next[0] > names[0].length, next[1] > names[1].length] as const;
      if (isEnd[0] || isEnd[1]) {
        this.end(isEnd[0] && isEnd[1], next);
        return false;
      }
      this.compare(next, names[0][next[0] - 1] === names[1][next[1] - 1]);
      if (this.complete) return false;
      this.seen = next;
    }
    return true;
  }

  /** The next step that both tell. */
  private next(names: Uint8Array, after: number): number {
    let step = after + 1;
    while (step <= names.length && this.told[names[step - 1] ?? 0] === false) step++;
    return step;
  }

  private compare([one, other]: Steps, hasSameName: boolean): void {
    const [a, b] = [this.one.timeline, this.other.timeline];
    const isSameText = hasSameName && a.line(one) === b.line(other);
    if (!isSameText || one !== other) this.text ??= this.first();
    if (isSameText) return;
    const [did, didOther] = [a.event(one), b.event(other)];
    const isSame = hasSameName && did !== null && didOther !== null && sameDeed(did, didOther);
    if (!isSame) this.deed = [one, other];
  }

  /** Up to here the texts were the same, step by step. */
  private first(): Steps {
    const [one, other] = this.seen;
    return [one + 1, other + 1];
  }

  /** One of them, or both, tell no more. */
  private end(areBoth: boolean, next: Steps): void {
    const { one, other } = this;
    if (!one.complete || !other.complete) return;
    const last: Steps = [one.timeline.length, other.timeline.length];
    this.isOver = true;
    const isLonger = last[0] !== last[1];
    const found: Steps = [Math.min(next[0], last[0]), Math.min(next[1], last[1])];
    if (!areBoth) this.deed = found;
    if (!areBoth || isLonger) this.text ??= found;
  }
}
