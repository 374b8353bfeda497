import { Trace } from '../replay/trace.js';
import { Library } from './library.js';
import type { Outcome } from './library.js';
import { readMade } from './made.js';
import type { Made } from './made.js';
import { Maker, moduleOf } from './maker.js';
import type { Options } from './options.js';
import { sceneText } from './sketch.js';
import type { Sketch } from './sketch.js';

/** A longer run is partial: the page shows its beginning. */
const mostEvents = 1_000_000;
/** Milliseconds of a run for which the page may wait. */
const quick = 16;
/** The events that a run may have if the last one had so many. */
const mostAfter = (events: number): number => 2 * events + 1000;

/** The result of a run. */
export interface Traced {
  /** Null if the scene or the options were refused. */
  readonly trace: Trace | null;
  readonly messages: string;
}

function requestOf(scene: Sketch | string, options: Options, most: number): string {
  const file = typeof scene === 'string' ? scene : sceneText(scene);
  return `${JSON.stringify({ ...options, most_events: most })}\n${file}`;
}

/** Runs scenes, one at a time. Only the newest of the waiting scenes is run. */
export class Tracer {
  private readonly maker: Maker<'trace'>;
  /** The library in the page's own thread. */
  private own: Library | null = null;
  /** The events of the last run, if it was quick. */
  private lastQuick: number | null = null;

  constructor(
    private readonly library: Blob,
    private readonly tell: (traced: Traced) => void,
    private readonly fail: (error: unknown) => void,
  ) {
    this.maker = new Maker(library, 'trace', (answer) => tell(this.taken(answer)), fail);
  }

  run(scene: Sketch | string, options: Options, most = mostEvents): void {
    this.maker.ask(requestOf(scene, options, most));
  }

  /**
   * Runs a scene that hardly differs from the last one, as in a drag, if the last run was quick. Its result is reported
   * before the call returns, so that it is seen a frame earlier than a worker's. Returns whether there is a result.
   */
  runAtOnce(scene: Sketch, options: Options): boolean {
    const { own, lastQuick, maker } = this;
    // The page's own thread has no functions for surfaces.
    if (lastQuick === null || maker.isBusy || scene.curves !== null) return false;
    if (own === null) {
      this.prepare();
      return false;
    }
    const outcome = own.run(requestOf(scene, options, mostAfter(lastQuick)));
    const traced = this.taken({ ...outcome, made: outcome.made && readMade(outcome.made) });
    if (traced.trace?.shortened) return false;
    this.tell(traced);
    return true;
  }

  private prepare(): void {
    void moduleOf(this.library)
      .then((module) => (this.own ??= new Library(module, () => 'no functions here')))
      .catch(this.fail);
  }

  private taken({ made, messages, milliseconds }: Outcome<Made>): Traced {
    const trace = made && traceOf(made);
    this.lastQuick = milliseconds <= quick ? (trace?.timeline.length ?? null) : null;
    return { trace, messages };
  }

  /** Cancels the current and the waiting run. */
  forget(): void {
    this.maker.forget();
  }
}

function traceOf({ header, blocks, end }: Made): Trace {
  const trace = new Trace(header);
  for (const block of blocks) trace.add({ is: 'part', block, read: 1 });
  const isPartial = end.partial === true;
  const shortened = isPartial ? { why: 'partial' as const, line: end.events + 1 } : null;
  trace.add({ is: 'end', end, shortened });
  return trace;
}
