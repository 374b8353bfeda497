import type { History } from '../history/history.js';
import { eventNames } from '../trace/events.js';
import type { Event, Method } from '../trace/events.js';
import type { Trace } from '../trace/read.js';

/** What one may go to: steps of one kind, or those of the chosen pixel. */
export const goalNames = ['split', 'ael', 'wrong', 'pixel'] as const;
export type GoalName = (typeof goalNames)[number];
export type Goal = GoalName | { readonly polygon: string };

const ofMethod: Readonly<Record<Method, readonly GoalName[]>> = {
  warnock: ['split', 'wrong', 'pixel'],
  zbuffer: ['ael', 'wrong', 'pixel'],
};

export const goalsOf = (method: Method): readonly GoalName[] => ofMethod[method];

const isGoal: Readonly<Record<Exclude<GoalName, 'pixel'>, (event: Event) => boolean>> = {
  split: (event) => event.e === 'decide' && event.case === 'split',
  ael: (event) => event.e === 'ael_add' || (event.e === 'ael_drop' && event.edges.length > 0),
  wrong: ({ e }) => e === 'disagree',
};

const namesOf: Readonly<Record<Exclude<GoalName, 'pixel'>, readonly string[]>> = {
  split: ['decide'],
  ael: ['ael_add', 'ael_drop'],
  wrong: ['disagree'],
};

/** The steps that one may go to, looked for when they are first asked for. */
export class Goals {
  private readonly found = new Map<string, readonly number[]>();

  constructor(private readonly trace: Trace) {}

  stepsOf(goal: Goal, history: History | null): readonly number[] {
    if (goal === 'pixel') return history?.entries.map(({ step }) => step) ?? [];
    const key = JSON.stringify(goal);
    const steps = this.found.get(key) ?? this.search(goal);
    this.found.set(key, steps);
    return steps;
  }

  private search(goal: Exclude<Goal, 'pixel'>): readonly number[] {
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

/** The nearest of the rising steps before one and after it. */
export function around(
  steps: readonly number[],
  step: number,
): { readonly back: number | null; readonly forward: number | null } {
  let from = 0;
  let end = steps.length;
  while (from < end) {
    const middle = (from + end) >> 1;
    if ((steps[middle] ?? Infinity) < step) from = middle + 1;
    else end = middle;
  }
  const next = steps[from] === step ? from + 1 : from;
  return { back: steps[from - 1] ?? null, forward: steps[next] ?? null };
}
