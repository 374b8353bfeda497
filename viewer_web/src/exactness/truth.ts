import type { Language } from '../language/language.js';
import type { Timeline } from '../replay/timeline.js';
import type { Trace } from '../replay/trace.js';
import type { SaidDecision } from '../trace/event-table.js';
import { numberOf } from '../trace/events.js';
import type { Event } from '../trace/events.js';
import type { Finding } from './finding.js';
import { certaintyOf } from './certainty.js';
import type { Certainty } from './certainty.js';

const disagree = numberOf.get('disagree');

/** The right answers to the decisions of an unchecked run. They come from the same run, repeated with checks. */
export class Truth {
  private constructor(
    private readonly checked: Trace,
    /** The step of the checked run for each step of the run, from 1. */
    private readonly places: Uint32Array,
    /** The steps of the run with a wrong decision. */
    readonly wrong: readonly number[],
  ) {}

  /** Null if the checked run differs. */
  static of({ timeline }: Trace, checked: Trace): Truth | null {
    const { names } = checked.timeline;
    const places = new Uint32Array(timeline.length + 1);
    const wrong: number[] = [];
    let step = 0;
    for (let i = 0; i < names.length; i++) {
      if (names[i] === disagree) {
        if (wrong.at(-1) !== step) wrong.push(step);
      } else if (step === timeline.length) break;
      else {
        places[++step] = i + 1;
        if (!isSame(timeline, step, checked.timeline, i + 1)) return null;
      }
    }
    return step === timeline.length ? new Truth(checked, places, wrong) : null;
  }

  decision(step: number, language: Language): SaidDecision | null {
    return this.checked.timeline.decision(this.places[step] ?? 0, language);
  }
}

/** Whether both steps have the same event, apart from the fields of the check. */
function isSame(one: Timeline, step: number, checked: Timeline, place: number): boolean {
  const line = checked.line(place).trimEnd();
  const own = one.line(step).trimEnd();
  if (line === own || line.startsWith(`${own.slice(0, -1)},"exact":`)) return true;
  const [event, truth] = [one.event(step), checked.event(place)];
  if (event === null || truth === null) return false;
  return written(event) === written(truth);
}

const written = (event: Event): string =>
  JSON.stringify(
    Object.entries(event)
      .filter(([key]) => key !== 'exact' && key !== 'by' && key !== 'operands')
      .sort(([a], [b]) => (a < b ? -1 : 1)),
  );

/** Why the library cannot check a run. */
export type Unable = 'otherRun' | 'notHere' | 'tooLong' | 'failed';

/** How a run's decisions are known to be right or wrong, and, once requested, those worth looking at. */
export type Check = Known & { readonly findings?: readonly Finding[] };
type Known =
  | { readonly is: Certainty | 'checking' }
  | { readonly is: 'found'; readonly truth: Truth }
  | { readonly is: 'unable'; readonly why: Unable; readonly messages: string };

const certainties: Readonly<Record<Certainty, Check>> = {
  checked: { is: 'checked' },
  certain: { is: 'certain' },
  unchecked: { is: 'unchecked' },
};

/** The check that the trace alone provides. */
export const ownCheck = (trace: Trace): Check => certainties[certaintyOf(trace)];

/** The decision of a step, from the check or else from the trace itself. */
export const decisionBy = (
  check: Check,
  { timeline }: Trace,
  step: number,
  language: Language,
): SaidDecision | null => (check.is === 'found' ? check.truth : timeline).decision(step, language);

/** Requests a check of the run from the owner of the library, from anywhere in the player. */
export function askCheck(from: EventTarget): void {
  from.dispatchEvent(new Event('vidno-check', { bubbles: true, composed: true }));
}
