import { findingsIn } from '../exactness/finding.js';
import type { Finding } from '../exactness/finding.js';
import type { Trace } from '../replay/trace.js';
import { numberOf } from '../trace/events.js';
import { Maker } from './maker.js';
import { runs } from './options.js';
import { sceneText } from './sketch.js';

/** Only this many events of a longer run are searched. */
const mostEvents = 1_000_000;

const disagree = numberOf.get('disagree');

/** Findings with the steps of a trace, which may report wrong decisions by steps of their own; those are not counted. */
export function placedIn(
  names: ArrayLike<number>,
  findings: readonly Finding[],
): readonly Finding[] {
  const steps: number[] = [];
  for (let i = 0; i < names.length; i++) if (names[i] !== disagree) steps.push(i + 1);
  return findings.map((each) => ({ ...each, step: steps[each.step - 1] ?? each.step }));
}

/** Lists the decisions of runs that are worth looking at, with the page's library, one run at a time. */
export class Finder {
  private readonly maker: Maker<'findings'>;
  private wanted: Trace | null = null;
  private readonly asked = new WeakSet<Trace>();

  constructor(
    library: Blob,
    private readonly tell: (trace: Trace, findings: readonly Finding[]) => void,
  ) {
    this.maker = new Maker(
      library,
      'findings',
      ({ made }) => this.take(made),
      () => this.take(null),
    );
  }

  /** Lists the decisions of a run. Only the newest of the waiting runs is listed. */
  ask(trace: Trace): void {
    const { method, edition, kernel, detail, scene } = trace.header;
    const options = { method, edition, kernel, detail, check: true };
    if (!runs(options) || this.asked.has(trace)) return;
    this.asked.add(trace);
    if (this.wanted !== null) this.asked.delete(this.wanted);
    this.wanted = trace;
    const request = JSON.stringify({ ...options, most_events: mostEvents });
    this.maker.ask(`${request}\n${sceneText(scene)}`);
  }

  private take(made: string | null): void {
    const { wanted } = this;
    if (this.maker.isBusy || wanted === null) return;
    this.wanted = null;
    if (made !== null) this.tell(wanted, placedIn(wanted.timeline.names, findingsIn(made)));
  }
}
