import { algorithmOf } from '../algorithm/algorithm.js';
import type { Trace } from '../replay/trace.js';
import { depthChanges, eventNames } from '../trace/events.js';
import type { Event, EventName } from '../trace/events.js';
import type { Header } from '../trace/header.js';
import { indexFrom } from './goals.js';

/** The action at each step of an event name. */
export type Watched = Readonly<Partial<Record<EventName, (step: number) => void>>>;

/** The records that an algorithm keeps of the course of a run. */
export interface Book {
  readonly header: Header;
  eventAt(step: number): Event | null;
  /** The index of a polygon in the scene. */
  indexOf(polygon: string): number;
  /** Another item becomes current; see `Stretches`. */
  begin(step: number, part: number, level?: number): void;
  /** No item is current any more: the following steps concern the whole run. */
  end(step: number): void;
  /** The case of the current window. */
  decide(part: number): void;
  changeAel(step: number): void;
}

/** The possible cases of a window, in the order of the procedure. */
export const cases = [
  'empty',
  'surrounded',
  'pixel',
  'single',
  'split',
] as const satisfies readonly Event<'decide'>['case'][];
export type Case = (typeof cases)[number];

/**
 * Consecutive steps with the same current window, polygon, curve or clip polygon. There may be some 100 000 stretches, so
 * each of their properties is a column.
 */
export interface Stretches {
  readonly first: number[];
  /** For a window, the number of divisions that led to it plus 1; for a list, how often it was put back; otherwise 1. */
  readonly level: number[];
  /**
   * The index in `cases` for a window, the index in the scene for a polygon or a curve; -1 if undecided, or if nothing is
   * current.
   */
  readonly part: number[];
}

const atOnce = 16384;

/**
 * The course of a run: the current item, the call depth, and the steps of rare events. It is built in one pass over the
 * event names, which a page may spread over frames and which continues as the trace grows. Only events that decide a
 * window, name a polygon or a curve, or change the AEL are parsed.
 */
export class Course {
  readonly stretches: Stretches = { first: [], level: [], part: [] };
  /** The call depth after each step. */
  depths: Uint8Array;
  readonly ael: number[] = [];
  readonly wrong: number[];
  readonly faults: number[] = [];
  deepest = 1;
  finest = 1;

  private seen = 0;
  private depth = 1;
  private readonly depthChange: readonly number[];
  private readonly watch: readonly (((step: number) => void) | undefined)[];
  private readonly indices: ReadonlyMap<string, number>;

  /** `wrong`: the steps at which decisions are known to be wrong although the trace does not say so. */
  constructor(
    readonly trace: Trace,
    wrong: readonly number[] = [],
  ) {
    this.wrong = [...wrong];
    const { header, timeline } = trace;
    this.depths = new Uint8Array(timeline.length + 1).fill(1, 0, 1);
    this.depthChange = depthChanges(header.detail);
    this.indices = new Map(header.scene.polygons.map(({ id }, i) => [id, i]));
    const watched: Watched = {
      ...algorithmOf(header).course(this.book()),
      disagree: (step) => this.wrong.push(step),
      fault: (step) => this.faults.push(step),
    };
    this.watch = eventNames.map((name) => watched[name]);
  }

  /** The number of steps of the run. */
  get length(): number {
    return this.trace.timeline.length;
  }

  get complete(): boolean {
    return this.seen >= this.length;
  }

  /** Continues for about this time. Returns whether all steps were processed. */
  read(milliseconds = Infinity): boolean {
    const end = performance.now() + milliseconds;
    do this.readSome();
    while (!this.complete && performance.now() < end);
    return this.complete;
  }

  /** The index of the stretch that contains a step, or -1. */
  indexAt(step: number): number {
    return indexFrom(this.stretches.first, step + 1) - 1;
  }

  private readSome(): void {
    const { names } = this.trace.timeline;
    if (this.depths.length <= this.length) this.makeRoom();
    const end = Math.min(this.seen + atOnce, this.length);
    while (this.seen < end) {
      const name = names[this.seen] ?? 0;
      this.seen++;
      this.depth += this.depthChange[name] ?? 0;
      this.depths[this.seen] = this.depth;
      this.deepest = Math.max(this.deepest, this.depth);
      this.watch[name]?.(this.seen);
    }
  }

  /** Grows the column of depths with the trace. */
  private makeRoom(): void {
    const larger = new Uint8Array(2 * this.length + 1);
    larger.set(this.depths);
    this.depths = larger;
  }

  /** The records that an algorithm's events write to. */
  private book(): Book {
    const { stretches, indices, ael, trace } = this;
    return {
      header: trace.header,
      eventAt: (step) => trace.timeline.event(step),
      indexOf: (polygon) => indices.get(polygon) ?? -1,
      begin: (step, part, level = 1) => {
        this.finest = Math.max(this.finest, level);
        stretches.first.push(step);
        stretches.level.push(level);
        stretches.part.push(part);
      },
      end: (step) => {
        stretches.first.push(step);
        stretches.level.push(1);
        stretches.part.push(-1);
      },
      decide: (part) => {
        const { length } = stretches.part;
        if (length > 0) stretches.part[length - 1] = part;
      },
      changeAel: (step) => ael.push(step),
    };
  }
}
