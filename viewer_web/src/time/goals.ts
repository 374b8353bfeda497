import type { History } from '../history/history.js';
import { eventNames } from '../trace/events.js';
import type { Event, Method } from '../trace/events.js';
import type { Trace } from '../trace/read.js';
import type { Bookmarks } from './bookmarks.js';

/** What one may go to: steps of one kind, those of the chosen pixel, or bookmarks. */
export const goalNames = ['split', 'ael', 'wrong', 'pixel', 'bookmark'] as const;
export type GoalName = (typeof goalNames)[number];
/** These are not looked for in the trace. */
type Given = 'pixel' | 'bookmark';
type SearchedName = Exclude<GoalName, Given>;
export type Goal = GoalName | { readonly polygon: string };

const ofMethod: Readonly<Record<Method, readonly GoalName[]>> = {
  warnock: ['split', 'wrong', 'pixel', 'bookmark'],
  zbuffer: ['ael', 'wrong', 'pixel', 'bookmark'],
};

export const goalsOf = (method: Method): readonly GoalName[] => ofMethod[method];

export function changesAel(event: Event): boolean {
  return event.e === 'ael_add' || (event.e === 'ael_drop' && event.edges.length > 0);
}

const isGoal: Readonly<Record<SearchedName, (event: Event) => boolean>> = {
  split: (event) => event.e === 'decide' && event.case === 'split',
  ael: changesAel,
  wrong: ({ e }) => e === 'disagree',
};

const namesOf: Readonly<Record<SearchedName, readonly string[]>> = {
  split: ['decide'],
  ael: ['ael_add', 'ael_drop'],
  wrong: ['disagree'],
};

/** The steps that one may go to, looked for when they are first asked for. */
export class Goals {
  private readonly found = new Map<string, readonly number[]>();

  constructor(private readonly trace: Trace) {}

  stepsOf(goal: Goal, history: History | null, bookmarks: Bookmarks = []): readonly number[] {
    if (goal === 'pixel') return history?.entries.map(({ step }) => step) ?? [];
    if (goal === 'bookmark') return bookmarks.map(({ step }) => step);
    const key = JSON.stringify(goal);
    const steps = this.found.get(key) ?? this.search(goal);
    this.found.set(key, steps);
    return steps;
  }

  private search(goal: Exclude<Goal, Given>): readonly number[] {
    if (typeof goal === 'object') return this.ofPolygon(goal.polygon);
    const wanted = eventNames.map((name) => namesOf[goal].includes(name));
    return this.steps((name) => wanted[name] === true, isGoal[goal]);
  }

  /** In the Z-buffer algorithm all from one `polygon` to the next concerns that one. */
  private ofPolygon(polygon: string): readonly number[] {
    let inHand: string | null = null;
    return this.steps(
      () => true,
      (event) => {
        if (event.e === 'polygon') inHand = event.polygon;
        return 'polygon' in event ? event.polygon === polygon : inHand === polygon;
      },
    );
  }

  private steps(
    named: (name: number) => boolean,
    wanted: (event: Event) => boolean,
  ): readonly number[] {
    const { timeline } = this.trace;
    const steps: number[] = [];
    timeline.names.forEach((name, i) => {
      const event = named(name) ? timeline.event(i + 1) : null;
      if (event !== null && wanted(event)) steps.push(i + 1);
    });
    return steps;
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
