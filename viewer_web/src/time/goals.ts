import { algorithmOf } from '../algorithm/algorithm.js';
import type { Timeline } from '../replay/timeline.js';
import type { Trace } from '../replay/trace.js';
import { all, only } from '../replay/wanted.js';
import type { Wanted } from '../replay/wanted.js';
import { eventNames, kinds, numberOf } from '../trace/events.js';
import type { EventName, Method } from '../trace/events.js';
import type { Bookmarks } from './bookmarks.js';

/** The kinds of goals: steps of some events, those of the chosen pixel, and bookmarks. */
export const goalNames = [
  'split',
  'ael',
  'curve',
  'crossing',
  'list',
  'region',
  'wrong',
  'pixel',
  'bookmark',
] as const;
export type GoalName = (typeof goalNames)[number];
/** Goals that are not searched for in the trace. */
type Given = 'pixel' | 'bookmark';
type SearchedName = Exclude<GoalName, Given>;
export type Goal = GoalName | { readonly polygon: string };

/** A kind of goal in the runs of an algorithm. */
export interface OwnGoal {
  readonly name: SearchedName;
  readonly at: readonly EventName[];
  /** Which of these steps are goals. If possible it uses only event names, and no events, because a run may be long. */
  isGoal?(timeline: Timeline, step: number): boolean;
}

/** The goals of all algorithms. */
const wrong: OwnGoal = { name: 'wrong', at: ['disagree'] };

const searched = (method: Method): readonly OwnGoal[] => [...algorithmOf({ method }).goals, wrong];

export const goalsOf = (method: Method): readonly GoalName[] => [
  ...searched(method).map(({ name }) => name),
  'pixel',
  'bookmark',
];

const havePolygon: Wanted = eventNames.map((name) => kinds[name].fields.includes('polygon'));

/** Whether a step is a goal; `name` is the number of its event's name. */
type Test = (step: number, name: number) => boolean;

/** Searches for goals among the steps with certain event names, each time up to the current end of the trace. */
class Search {
  readonly steps: number[] = [];
  private seen = 0;

  constructor(
    private readonly trace: Trace,
    private readonly wanted: Wanted,
    private readonly isGoal: Test,
  ) {}

  goOn(): readonly number[] {
    const { complete, timeline } = this.trace;
    const { names } = timeline;
    const end = complete ? names.length : names.length - 1; // the event after the last one is not known yet
    for (; this.seen < end; this.seen++) {
      const step = this.seen + 1;
      const name = names[this.seen] ?? 0;
      if (this.wanted[name] === true && this.isGoal(step, name)) this.steps.push(step);
    }
    return this.steps;
  }
}

/** Whether the line of an event names the polygon; usually without parsing it. */
function namesPolygon(line: string, polygon: string): boolean {
  const key = '"polygon":';
  const at = line.indexOf(key);
  if (at >= 0 && !line.includes('\\')) {
    return line.startsWith(JSON.stringify(polygon), at + key.length);
  }
  return (JSON.parse(line) as { polygon?: string }).polygon === polygon;
}

/** The steps of a pixel's history. */
export interface Followed {
  readonly entries: readonly { readonly step: number }[];
}

/** The goals of a run, searched for on the first request. */
export class Goals {
  private readonly searches = new Map<string, Search>();

  constructor(private readonly trace: Trace) {}

  stepsOf(goal: Goal, history: Followed | null, bookmarks: Bookmarks = []): readonly number[] {
    if (goal === 'pixel') return history?.entries.map(({ step }) => step) ?? [];
    if (goal === 'bookmark') return bookmarks.map(({ step }) => step);
    const key = JSON.stringify(goal);
    const search = this.searches.get(key) ?? this.searchFor(goal);
    this.searches.set(key, search);
    return search.goOn();
  }

  private searchFor(goal: Exclude<Goal, Given>): Search {
    const { trace } = this;
    if (typeof goal === 'object') return new Search(trace, all, this.isOf(goal.polygon));
    const found = searched(trace.header.method).find(({ name }) => name === goal);
    const { at = [], isGoal } = found ?? {};
    return new Search(trace, only(...at), (step) => isGoal?.(trace.timeline, step) ?? true);
  }

  /** In the Z-buffer algorithm, all steps from one `polygon` to the next concern that polygon. */
  private isOf(polygon: string): Test {
    const { timeline } = this.trace;
    let current = false;
    return (step, name) => {
      if (havePolygon[name] !== true) return current;
      const named = namesPolygon(timeline.line(step), polygon);
      if (name === numberOf.get('polygon')) current = named;
      return named;
    };
  }
}

/** The index of the first of the sorted steps that is not before a step. */
export function indexFrom(steps: readonly number[], step: number): number {
  let from = 0;
  let end = steps.length;
  while (from < end) {
    const middle = (from + end) >> 1;
    if ((steps[middle] ?? Infinity) < step) from = middle + 1;
    else end = middle;
  }
  return from;
}

/** The nearest of the sorted steps before and after a step. */
export function around(
  steps: readonly number[],
  step: number,
): { readonly back: number | null; readonly forward: number | null } {
  const from = indexFrom(steps, step);
  const next = steps[from] === step ? from + 1 : from;
  return { back: steps[from - 1] ?? null, forward: steps[next] ?? null };
}
