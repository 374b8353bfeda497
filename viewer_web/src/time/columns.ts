import { cases } from './course.js';
import type { Course } from './course.js';
import { indexFrom } from './goals.js';
import { isIn, wholeOf } from './range.js';
import type { Range } from './range.js';

/** The number of steps in a column that belong to one case or polygon. */
export interface Share {
  readonly part: number;
  readonly steps: number;
}

/** The nesting depth of the steps of a column: the mean and the maximum. */
export interface Depth {
  readonly mean: number;
  readonly most: number;
}

/**
 * One column of the strip, one canvas pixel wide. If it stands for many steps, it has the shares of all cases, the mean and
 * the greatest depth, and whether any rare event occurs. So a single wrong decision among thousands of steps is visible,
 * and common events are shown in proportion.
 */
export interface Column {
  /** Its steps: from `first` up to, not including, `end`. */
  readonly first: number;
  readonly end: number;
  /** The shares by part, without parts that have no steps. */
  readonly shares: readonly Share[];
  readonly levels: Depth;
  readonly calls: Depth;
  readonly ael: boolean;
  readonly wrong: boolean;
  readonly fault: boolean;
}

/** The place of a step on a strip of a width: the first step of the range at 0, the last one at the end. */
export function placeOf(step: number, { from, to }: Range, width: number): number {
  return to === from ? 0 : ((step - from) / (to - from)) * width;
}

/** The step nearest to a place. */
export function stepAt(place: number, { from, to }: Range, width: number): number {
  if (width <= 0) return from;
  return from + Math.min(Math.max(0, Math.floor((place / width) * (to - from) + 0.5)), to - from);
}

/** Every step is in a column. If there are fewer steps than columns, a step is in several. */
function stepsOf(column: number, count: number, range: Range): readonly [number, number] {
  const first = stepAt(column, range, count);
  const end = column === count - 1 ? range.to + 1 : stepAt(column + 1, range, count);
  return [first, Math.max(first + 1, end)];
}

const happens = (steps: readonly number[], first: number, end: number): boolean =>
  (steps[indexFrom(steps, first)] ?? Infinity) < end;

/** The given number of columns for the strip of a run, or of a part of it. The course of the run must be complete. */
export function columnsOf(
  course: Course,
  count: number,
  range = wholeOf(course.length),
): readonly Column[] {
  const counter = new Counter(course);
  return Array.from({ length: count }, (_, i) => {
    const [first, end] = stepsOf(i, count, range);
    return {
      first,
      end,
      ...counter.count(first, end),
      calls: callsIn(course.depths, first, end),
      ael: happens(course.ael, first, end),
      wrong: happens(course.wrong, first, end),
      fault: happens(course.faults, first, end),
    };
  });
}

/** Counts the steps of each part, column by column, in the same array. */
class Counter {
  private readonly steps: Uint32Array;

  constructor(private readonly course: Course) {
    const { polygons, curves } = course.trace.header.scene;
    const parts = Math.max(cases.length, polygons.length, curves?.length ?? 0);
    this.steps = new Uint32Array(parts);
  }

  count(first: number, end: number): Pick<Column, 'shares' | 'levels'> {
    const { stretches, length } = this.course;
    const found: number[] = [];
    let sum = 0;
    let most = 0;
    for (let i = Math.max(0, this.course.indexAt(first)); ; i++) {
      const from = stretches.first[i] ?? Infinity;
      if (from >= end) break;
      const next = stretches.first[i + 1] ?? length + 1;
      const steps = Math.min(end, next) - Math.max(first, from);
      const level = stretches.level[i] ?? 0;
      const part = stretches.part[i] ?? -1;
      sum += steps * level;
      most = Math.max(most, level);
      if (part >= 0) this.add(part, steps, found);
    }
    return { shares: this.take(found), levels: { mean: sum / (end - first), most } };
  }

  private add(part: number, steps: number, found: number[]): void {
    const before = this.steps[part] ?? 0;
    if (before === 0) found.push(part);
    this.steps[part] = before + steps;
  }

  private take(found: number[]): readonly Share[] {
    return found
      .sort((a, b) => a - b)
      .map((part) => {
        const steps = this.steps[part] ?? 0;
        this.steps[part] = 0;
        return { part, steps };
      });
  }
}

function callsIn(depths: Uint8Array, first: number, end: number): Depth {
  let sum = 0;
  let most = 0;
  for (let step = first; step < end; step++) {
    const depth = depths[step] ?? 0;
    sum += depth;
    most = Math.max(most, depth);
  }
  return { mean: sum / (end - first), most };
}

/**
 * The step that a place means: the nearest marked step within reach, where earlier lists take precedence, or else the
 * nearest step. A mark is hard to hit to the pixel.
 */
export function aimedAt(
  place: number,
  range: Range,
  width: number,
  marked: readonly (readonly number[])[],
): number {
  const reach = 3;
  const aimed = stepAt(place, range, width);
  const off = (step: number): number => Math.abs(placeOf(step, range, width) - place);
  for (const steps of marked) {
    const next = indexFrom(steps, aimed);
    const near = [steps[next - 1], steps[next]].filter((step) => step !== undefined);
    const [nearest] = near.sort((a, b) => off(a) - off(b));
    if (nearest !== undefined && isIn(range, nearest) && off(nearest) <= reach) return nearest;
  }
  return aimed;
}
