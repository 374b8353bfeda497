import { eventNames } from '../trace/events.js';
import type { Event, EventName } from '../trace/events.js';
import { depthChanges } from '../replay/state.js';
import type { Trace } from '../replay/trace.js';
import { changesAel, indexFrom } from './goals.js';

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
 * Steps in a row with the same window, polygon, curve or clip polygon in hand, from its first step to the next one's. There may be
 * some 100 000 of them, so that each of their properties is a column.
 */
export interface Stretches {
  readonly first: number[];
  /** How often the area was split to get this window, from 1 for the area itself; 1 for a polygon or a curve. */
  readonly level: number[];
  /** What the window comes to, as an index of `cases`; the polygon's index in the scene, or the curve's; -1 if not decided. */
  readonly part: number[];
}

const atOnce = 16384;

/**
 * The course of a run: what is in hand, how deep it is nested, and where something rare happens. It is gathered in one
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
  private level = 0;
  /** The levels of the windows on the stack: a window that is pushed is a part of the one in hand. */
  private readonly stack: number[] = [];
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
    this.watch = eventNames.map((name) => this.on[name]);
    this.indices = new Map(header.scene.polygons.map(({ id }, i) => [id, i]));
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

  private begin(first: number, level: number, part: number): void {
    this.stretches.first.push(first);
    this.stretches.level.push(level);
    this.stretches.part.push(part);
  }

  private readonly on: Partial<Record<EventName, (step: number) => void>> = {
    push: () => this.stack.push(this.level + 1),
    pop: (step) => {
      this.level = this.stack.pop() ?? 1;
      this.finest = Math.max(this.finest, this.level);
      this.begin(step, this.level, -1);
    },
    decide: (step) => {
      const event = this.trace.timeline.event(step);
      const { part } = this.stretches;
      if (event?.e === 'decide' && part.length > 0)
        part[part.length - 1] = cases.indexOf(event.case);
    },
    polygon: (step) => {
      const event = this.trace.timeline.event(step);
      if (event?.e === 'polygon') this.begin(step, 1, this.indices.get(event.polygon) ?? -1);
    },
    curve: (step) => {
      const event = this.trace.timeline.event(step);
      if (event?.e === 'curve') this.begin(step, 1, event.curve);
    },
    pop_list: (step) => {
      const event = this.trace.timeline.event(step);
      if (event?.e === 'pop_list') this.begin(step, 1, this.indices.get(event.clip) ?? -1);
    },
    ael_add: (step) => this.ael.push(step),
    ael_drop: (step) => {
      const event = this.trace.timeline.event(step);
      if (event !== null && changesAel(event)) this.ael.push(step);
    },
    disagree: (step) => this.wrong.push(step),
    fault: (step) => this.faults.push(step),
  };
}
