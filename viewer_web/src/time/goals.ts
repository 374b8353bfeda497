import { all, only } from '../history/entry.js';
import type { Wanted } from '../history/entry.js';
import type { History } from '../history/history.js';
import type { Timeline } from '../state/timeline.js';
import { eventNames, kinds, numberOf } from '../trace/events.js';
import type { Event, Method } from '../trace/events.js';
import { methodKindOf } from '../trace/method-kind.js';
import type { MethodKind } from '../trace/method-kind.js';
import type { Trace } from '../trace/trace.js';
import type { Bookmarks } from './bookmarks.js';

/** What one may go to: steps of one kind, those of the chosen pixel, or bookmarks. */
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
/** These are not looked for in the trace. */
type Given = 'pixel' | 'bookmark';
type SearchedName = Exclude<GoalName, Given>;
export type Goal = GoalName | { readonly polygon: string };

const ofKind: Readonly<Record<MethodKind, readonly GoalName[]>> = {
  windows: ['split', 'wrong', 'pixel', 'bookmark'],
  scanlines: ['ael', 'wrong', 'pixel', 'bookmark'],
  curves: ['curve', 'crossing', 'wrong', 'pixel', 'bookmark'],
  regions: ['list', 'region', 'wrong', 'pixel', 'bookmark'],
};

export const goalsOf = (method: Method): readonly GoalName[] => ofKind[methodKindOf(method)];

export function changesAel(event: Event | null): boolean {
  return event?.e === 'ael_add' || (event?.e === 'ael_drop' && event.edges.length > 0);
}

/** What follows the decision to split. */
const splits: Wanted = only('push', 'skip', 'split_vertex');

const adding = numberOf.get('ael_add');

/** Most goals are known by their names, or by the next one: a long run is gone through without its events. */
const isGoal: Readonly<Record<SearchedName, (timeline: Timeline, step: number) => boolean>> = {
  split: ({ names }, step) => splits[names[step] ?? -1] === true,
  ael: (timeline, step) => timeline.names[step - 1] === adding || changesAel(timeline.event(step)),
  curve: () => true,
  crossing: () => true,
  list: () => true,
  region: () => true,
  wrong: () => true,
};

const wanted: Readonly<Record<SearchedName, Wanted>> = {
  split: only('decide'),
  ael: only('ael_add', 'ael_drop'),
  curve: only('curve'),
  crossing: only('intersection'),
  list: only('pop_list'),
  region: only('show'),
  wrong: only('disagree'),
};

const havePolygon: Wanted = eventNames.map((name) => 'polygon' in kinds[name].fields);

/** Whether a step, whose event's name has this number, is a goal. */
type Test = (step: number, name: number) => boolean;

/** Looks for goals among the steps whose events have certain names, each time as far as the trace has grown. */
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
    const end = complete ? names.length : names.length - 1; // the last one's next is still to come
    for (; this.seen < end; this.seen++) {
      const step = this.seen + 1;
      const name = names[this.seen] ?? 0;
      if (this.wanted[name] === true && this.isGoal(step, name)) this.steps.push(step);
    }
    return this.steps;
  }
}

/** Whether the line of an event names the polygon; as a rule without parsing it. */
function namesPolygon(line: string, polygon: string): boolean {
  const key = '"polygon":';
  const at = line.indexOf(key);
  if (at >= 0 && !line.includes('\\')) {
    return line.startsWith(JSON.stringify(polygon), at + key.length);
  }
  return (JSON.parse(line) as { polygon?: string }).polygon === polygon;
}

/** The steps that one may go to, looked for when they are first asked for. */
export class Goals {
  private readonly searches = new Map<string, Search>();

  constructor(private readonly trace: Trace) {}

  stepsOf(goal: Goal, history: History | null, bookmarks: Bookmarks = []): readonly number[] {
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
    return new Search(trace, wanted[goal], (step) => isGoal[goal](trace.timeline, step));
  }

  /** In the Z-buffer algorithm all from one `polygon` to the next concerns that one. */
  private isOf(polygon: string): Test {
    const { timeline } = this.trace;
    let inHand = false;
    return (step, name) => {
      if (havePolygon[name] !== true) return inHand;
      const named = namesPolygon(timeline.line(step), polygon);
      if (name === numberOf.get('polygon')) inHand = named;
      return named;
    };
  }
}

/** The index of the first of rising steps that is not before a step. */
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

/** The nearest of the rising steps before one and after it. */
export function around(
  steps: readonly number[],
  step: number,
): { readonly back: number | null; readonly forward: number | null } {
  const from = indexFrom(steps, step);
  const next = steps[from] === step ? from + 1 : from;
  return { back: steps[from - 1] ?? null, forward: steps[next] ?? null };
}
