import type { Timeline } from '../replay/timeline.js';
import { details, eventNames, kinds } from '../trace/events.js';
import type { Detail, Event, EventName } from '../trace/events.js';
import type { Trace } from '../replay/trace.js';

/** The fields that a check adds. */
const truths: ReadonlySet<string> = new Set(['exact', 'by']);

/** For each event name, the fields that describe the action. */
const deedFields = new Map<EventName, readonly string[]>(
  eventNames.map((name) => {
    const { fields, numbers } = kinds[name];
    return [name, fields.filter((key) => !truths.has(key) && !numbers.includes(key))];
  }),
);

const isSame = (a: unknown, b: unknown): boolean => JSON.stringify(a) === JSON.stringify(b);

/**
 * Whether two events do the same, each with its kernel's numbers: the same line of the listing, polygon, window, pixels,
 * order and answer. The fields of a check do not count.
 */
function sameDeed(a: Event, b: Event): boolean {
  if (a.e !== b.e || a.at !== b.at) return false;
  const [one, other] = [a, b] as unknown as readonly Readonly<Record<string, unknown>>[];
  return (deedFields.get(a.e) ?? []).every((key) => isSame(one?.[key], other?.[key]));
}

/** A step of each of two runs. */
export type Steps = readonly [one: number, other: number];

const atOnce = 256;

/**
 * For each event name, whether both runs have such events. One of them may be less detailed and lack some of the calls, or
 * be unchecked.
 */
function reportedByBoth(one: Detail, other: Detail): readonly boolean[] {
  const least = Math.min(details.indexOf(one), details.indexOf(other));
  const notInBoth: readonly EventName[] = one === other ? ['disagree'] : ['disagree', 'call'];
  return eventNames.map(
    (name) => !notInBoth.includes(name) && details.indexOf(kinds[name].from) <= least,
  );
}

/** Parses events only if their texts differ. */
function doSame(a: Timeline, one: number, b: Timeline, other: number): boolean {
  if (a.line(one) === b.line(other)) return true;
  const [did, didOther] = [a.event(one), b.event(other)];
  return did !== null && didOther !== null && sameDeed(did, didOther);
}

/**
 * The steps at which two runs of one method diverge: the first event with a different text, even in the last digit of a
 * number, and the first with a different action. Found in one pass, which may be spread over frames.
 */
export class Parting {
  /** Null until such a step is found. */
  text: Steps | null = null;
  deed: Steps | null = null;
  /** The steps compared so far. Up to the first different text they are the same; after that they do the same. */
  private seen: Steps = [0, 0];
  private isOver = false;
  private readonly isReported: readonly boolean[];

  constructor(
    private readonly one: Trace,
    private readonly other: Trace,
  ) {
    this.isReported = reportedByBoth(one.header.detail, other.header.detail);
  }

  /** Whether the search is over. */
  get complete(): boolean {
    return this.isOver || this.deed !== null;
  }

  /** Continues for about this time. Returns whether it is complete, or has to wait until the runs have grown. */
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

  /** Compares the texts of the next step of both runs. Returns whether there is more to compare. */
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

  /** Compares the actions of the next step that both runs have. Returns whether there is more to compare. */
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

  /** The next step of a kind that both runs have. */
  private next(names: Uint8Array, after: number): number {
    let step = after + 1;
    while (step <= names.length && this.isReported[names[step - 1] ?? 0] === false) step++;
    return step;
  }
}
