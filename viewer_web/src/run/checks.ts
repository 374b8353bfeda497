import type { Finding } from '../exactness/finding.js';
import { ownCheck, Truth } from '../exactness/truth.js';
import type { Check, Unable } from '../exactness/truth.js';
import type { Trace } from '../replay/trace.js';
import { Finder } from './finder.js';
import { runs } from './options.js';
import type { Options } from './options.js';
import { Tracer } from './tracer.js';
import type { Traced } from './tracer.js';

/** Milliseconds after which a check is cancelled in favour of a newer run. */
const patience = 1000;
const checking: Check = { is: 'checking' };
const unchecked: Check = { is: 'unchecked' };
const unable = (why: Unable, messages = ''): Check => ({ is: 'unable', why, messages });

/** Checks runs that were not checked, by repeating each with the page's library. */
export class Checks {
  private readonly tracer: Tracer;
  private readonly found = new WeakMap<Trace, Check>();
  private readonly finder: Finder;
  private readonly findings = new WeakMap<Trace, readonly Finding[]>();
  private readonly doubted = new WeakSet<Trace>();
  private wanted: Trace | null = null;
  private running: { readonly trace: Trace; readonly since: number } | null = null;

  constructor(
    library: Blob,
    private readonly changed: () => void,
  ) {
    this.tracer = new Tracer(
      library,
      (traced) => this.take(traced),
      () => this.settle(unable('failed')),
    );
    this.finder = new Finder(library, (trace, findings) => {
      this.findings.set(trace, findings);
      this.found.set(trace, this.with(trace, this.of(trace)));
      changed();
    });
  }

  of(trace: Trace): Check {
    const found = this.found.get(trace);
    if (found !== undefined) return found;
    const own = ownCheck(trace);
    return own.is === 'certain' && this.doubted.has(trace) ? unchecked : own;
  }

  /** Another program may have written the trace, so that its kernel alone proves nothing. */
  doubt(trace: Trace): void {
    this.doubted.add(trace);
  }

  /** Adds the decisions worth looking at, once they are known. */
  private with(trace: Trace, check: Check): Check {
    const findings = this.findings.get(trace);
    return findings === undefined ? check : { ...check, findings };
  }

  /** Checks a run that is completely read. Only the newest of the waiting runs is checked. */
  ask(trace: Trace): void {
    if (trace.complete && !this.findings.has(trace)) this.finder.ask(trace);
    if (this.of(trace).is !== 'unchecked' || !trace.complete) return;
    const { wanted, running } = this;
    if (wanted !== null) this.found.delete(wanted);
    this.wanted = trace;
    this.found.set(trace, checking);
    if (running !== null && performance.now() - running.since > patience) {
      this.tracer.forget();
      this.found.delete(running.trace);
      this.running = null;
    }
    if (this.running === null) this.next();
    this.changed();
  }

  private next(): void {
    const { wanted: trace } = this;
    this.wanted = null;
    if (trace === null) return;
    const { method, edition, kernel, detail, scene } = trace.header;
    const options: Options = { method, edition, kernel, detail, check: true };
    this.running = { trace, since: performance.now() };
    if (runs(options)) this.tracer.run(scene, options);
    else this.settle(unable('notHere'));
  }

  private take({ trace: checked, messages }: Traced): void {
    const run = this.running?.trace;
    if (run === undefined) return;
    if (checked === null) {
      this.settle(unable('failed', messages));
      return;
    }
    const truth = Truth.of(run, checked);
    if (truth !== null) this.settle({ is: 'found', truth });
    else this.settle(unable(checked.shortened === null ? 'otherRun' : 'tooLong'));
  }

  private settle(check: Check): void {
    const trace = this.running?.trace;
    if (trace !== undefined) this.found.set(trace, this.with(trace, check));
    this.running = null;
    this.next();
    this.changed();
  }
}
