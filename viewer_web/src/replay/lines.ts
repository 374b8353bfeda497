import { numberOf } from '../trace/events.js';
import type { FloatingHorizonEvents, Event } from '../trace/events.js';
import type { Point } from '../trace/values.js';

/** A visible part of a curve. */
export interface Line {
  readonly curve: number;
  readonly from: Point;
  readonly to: Point;
  /** The first and the last column under it. There are none if the last is less than the first. */
  readonly columns: readonly [first: number, last: number];
}

/** The steps of a run so far. */
export interface Told {
  readonly names: Uint8Array;
  event(step: number): Event | null;
}

type Drawn = FloatingHorizonEvents['draw_line'];

/** A step that drew: the last line after it, its segment, and the index of the line. */
interface Entry {
  readonly step: number;
  readonly index: number;
  readonly line: Line;
  readonly segment: string;
  readonly fromColumns: Drawn['fromColumns'];
  readonly toColumns: Drawn['toColumns'];
}

/** Whether a part of a segment is a point on a column. */
export function isPoint({
  fromColumns,
  toColumns,
}: Pick<Drawn, 'fromColumns' | 'toColumns'>): boolean {
  return fromColumns[0] === fromColumns[1] && fromColumns[0] === toColumns[1];
}

const drawing = numberOf.get('draw_line');
const beginning = numberOf.get('curve');

const isOn = ([left, right]: readonly [number, number]): boolean => left === right;

/**
 * The lines that a run has drawn. Each step that draws changes only the last line, or adds one. The last such step before a
 * given step thus determines its lines, and no keyframe needs to store them. They are computed on request.
 */
export class Lines {
  private readonly entries: Entry[] = [];
  /** The final form of each line. */
  private readonly final: Line[] = [];
  private seen = 0;
  private curve = -1;

  constructor(private readonly told: Told) {}

  /** The number of lines after a step, and the form of the last one at that step. */
  upTo(step: number): { readonly count: number; readonly last: Line | null } {
    this.read(step);
    const entry = this.entries[this.indexAt(step)];
    return entry === undefined
      ? { count: 0, last: null }
      : { count: entry.index + 1, last: entry.line };
  }

  /** The lines after a step. */
  at(step: number): readonly Line[] {
    const { count, last } = this.upTo(step);
    return last === null ? [] : [...this.final.slice(0, count - 1), last];
  }

  private read(step: number): void {
    const { names } = this.told;
    for (const end = Math.min(step, names.length); this.seen < end;) {
      const name = names[this.seen];
      this.seen++;
      if (name !== drawing && name !== beginning) continue;
      const event = this.told.event(this.seen);
      if (event?.e === 'curve') this.curve = event.curve;
      if (event?.e === 'draw_line') this.add(event, this.seen);
    }
  }

  /** See "What a reader keeps" in trace/FORMAT.md. */
  private add({ segment, from, to, fromColumns, toColumns }: Drawn, step: number): void {
    const { curve } = this;
    const last = this.entries.at(-1);
    const made = { step, segment: segment.join(), fromColumns, toColumns };
    const line: Line = { curve, from, to, columns: [fromColumns[1], toColumns[0]] };
    const goesOn =
      last?.line.curve === curve &&
      isOn(fromColumns) &&
      isOn(last.toColumns) &&
      last.toColumns[0] === fromColumns[0];
    if (!goesOn) this.put({ ...made, line, index: this.final.length });
    else if (isPoint(last)) this.put({ ...made, line, index: last.index });
    else if (last.segment === made.segment) {
      const { line: begun, index, fromColumns: begin } = last;
      const whole: Line = { ...begun, to, columns: [begun.columns[0], toColumns[0]] };
      this.put({ ...made, fromColumns: begin, line: whole, index });
    } else if (!isPoint(made)) this.put({ ...made, line, index: this.final.length });
  }

  private put(entry: Entry): void {
    this.entries.push(entry);
    this.final[entry.index] = entry.line;
  }

  /** The index of the last entry at or before a step, or -1. */
  private indexAt(step: number): number {
    let from = 0;
    let end = this.entries.length;
    while (from < end) {
      const middle = (from + end) >> 1;
      if ((this.entries[middle]?.step ?? Infinity) <= step) from = middle + 1;
      else end = middle;
    }
    return from - 1;
  }
}
