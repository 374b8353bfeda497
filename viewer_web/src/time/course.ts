import { algorithmOf } from '../algorithm/algorithm.js';
import { depthChanges } from '../replay/state.js';
import type { Trace } from '../replay/trace.js';
import { eventNames } from '../trace/events.js';
import type { Event, EventName } from '../trace/events.js';
import type { Header } from '../trace/header.js';
import { indexFrom } from './goals.js';

/** What is done at a step of an event's name. */
export type Watched = Readonly<Partial<Record<EventName, (step: number) => void>>>;

/** What an algorithm writes down of the course of a run. */
export interface Book {
  readonly header: Header;
  eventAt(step: number): Event | null;
  /** The place of a polygon in the scene. */
  indexOf(polygon: string): number;
  /** Another item becomes current: see `Stretches`. */
  begin(step: number, part: number, level?: number): void;
  /** Nothing is current any more: what follows concerns the whole run. */
  end(step: number): void;
  /** What the current window comes to. */
  decide(part: number): void;
  changeAel(step: number): void;
}

/** What may be decided of a window, in the order of the procedure. */
export const cases = [
  'empty',
  'surrounded',
  'pixel',
  'single',
  'split',
] as const satisfies readonly Event<'decide'>['case'][];
export type Case = (typeof cases)[number];

/**
 * Consecutive steps with the same current window, polygon, curve or clip polygon, from its first step to the next one's. There may be
 * some 100 000 of them, so that each of their properties is a column.
 */
export interface Stretches {
  readonly first: number[];
  /** How often the area was split to get this window, from 1 for the area itself; of a list, how often it was put back; else 1. */
  readonly level: number[];
  /** What the window comes to, as an index of `cases`; the polygon's index in the scene, or the curve's; -1 if not decided, or nothing is current. */
  readonly part: number[];
}

const atOnce = 16384;

/**
 * The course of a run: the current item, how deep it is nested, and where something rare happens. It is gathered in one
 * pass over the numbers of the events' names, which a page may spread over frames and which goes on as the trace grows;
 * only events that decide a window, name a polygon or a curve, or change AEL are asked for.
 */
export class Course {
  readonly stretches: Stretches = { first: [], level: [], part: [] };
  /** How deep the calls are nested after each step. */
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

  /** The steps are those at which decisions are known to be wrong though the trace does not say so. */
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

  /** The steps of the run. */
  get length(): number {
    return this.trace.timeline.length;
  }

  get complete(): boolean {
    return this.seen >= this.length;
  }

  /** Goes on for about so long; says whether all was seen. */
  read(milliseconds = Infinity): boolean {
    const end = performance.now() + milliseconds;
    do this.readSome();
    while (!this.complete && performance.now() < end);
    return this.complete;
  }

  /** The index of the stretch that a step belongs to, or -1. */
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

  /** The trace has grown. */
  private makeRoom(): void {
    const larger = new Uint8Array(2 * this.length + 1);
    larger.set(this.depths);
    this.depths = larger;
  }

  /** In which what an algorithm's events tell is written down. */
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
