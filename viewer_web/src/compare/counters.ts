import { algorithmOf } from '../algorithm/algorithm.js';
import { certaintyOf } from '../exactness/certainty.js';
import type { Trace } from '../replay/trace.js';
import { details, kinds, numberOf, tells } from '../trace/events.js';
import type { EventName } from '../trace/events.js';
import type { Header } from '../trace/header.js';
import type { Survey } from './survey.js';

export const counters = [
  'windows',
  'splits',
  'surrounds',
  'relations',
  'comparisons',
  'lists',
  'clips',
  'regions',
  'sides',
  'ael',
  'painted',
  'curves',
  'flags',
  'crossings',
  'lines',
  'wrong',
  'steps',
] as const;
export type Counter = (typeof counters)[number];

/** The counters that need more than the names of events. */
export type Summed = 'splits' | 'ael' | 'painted';

/** How often each happened; null for events that the trace does not have. */
export type Counts = Readonly<Record<Counter, number | null>>;

const every = 4096;
const cells = numberOf.size;

/** The number of events of each name, in columns `every` steps apart. */
class Tally {
  private readonly columns: Uint32Array[] = [new Uint32Array(cells)];

  constructor(private readonly trace: Trace) {}

  upTo(step: number): Uint32Array {
    const { names } = this.trace.timeline;
    const { columns } = this;
    const wanted = Math.floor(step / every);
    while (columns.length <= wanted) {
      columns.push(counted(columns.at(-1), names, (columns.length - 1) * every, every));
    }
    return counted(columns[wanted], names, wanted * every, step - wanted * every);
  }
}

function counted(
  before: Uint32Array | undefined,
  names: Uint8Array,
  first: number,
  count: number,
): Uint32Array {
  const counts = before?.slice() ?? new Uint32Array(cells);
  for (let i = first; i < first + count; i++) {
    const name = names[i] ?? 0;
    counts[name] = (counts[name] ?? 0) + 1;
  }
  return counts;
}

/** Whether a trace of this method and level has such events. */
function isReported({ method, detail }: Header, name: EventName): boolean {
  return tells(method, name) && details.indexOf(kinds[name].from) <= details.indexOf(detail);
}

/** The counters of a run. */
export class Counters {
  private readonly tally: Tally;

  constructor(
    private readonly trace: Trace,
    private readonly survey: Survey,
  ) {
    this.tally = new Tally(trace);
  }

  /** The counters up to a step, which must have been surveyed. */
  upTo(step: number): Counts {
    const { trace, survey } = this;
    const isOfCurves = trace.header.scene.curves !== null;
    const counts = this.tally.upTo(step);
    const { counts: names, sums } = algorithmOf(trace.header);
    const reported = (some: readonly EventName[]): readonly EventName[] =>
      some.filter((name) => isReported(trace.header, name));
    const named = (some: readonly EventName[]): number | null => {
      const counted = reported(some);
      if (counted.length === 0) return null;
      return counted.reduce((sum, name) => sum + (counts[numberOf.get(name) ?? 0] ?? 0), 0);
    };
    const none = Object.fromEntries(counters.map((name) => [name, null])) as Counts;
    const byName = Object.entries(names).map(([counter, some]) => [counter, named(some)]);
    const summed = sums
      .filter(({ at }) => reported(at).length > 0)
      .map(({ counter }) => [counter, survey.upTo(counter, step)]);
    return {
      ...none,
      ...(Object.fromEntries([...byName, ...summed]) as Partial<Counts>),
      lines: isOfCurves ? trace.timeline.linesAt(step).length : null,
      wrong: certaintyOf(trace) === 'unchecked' ? null : named(['disagree']),
      steps: step,
    };
  }
}
