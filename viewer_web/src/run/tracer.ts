import { traceOf } from '../replay/trace.js';
import type { Trace } from '../replay/trace.js';
import { Library } from './library.js';
import type { Outcome } from './library.js';
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
  /** The last request to the worker, and its options. */
  private asked: { readonly request: string; readonly options: Options } | null = null;
  /** The library in the page's own thread, after the first quick run, and the options of the last run prepared in it. */
  private own: Library | null = null;
  private prepared: Options | null = null;
  /** The events of the last run, if it was quick. */
  private lastQuick: number | null = null;

  constructor(
    private readonly library: Blob,
    private readonly tell: (traced: Traced) => void,
    private readonly fail: (error: unknown) => void,
    tellSlow?: () => void,
  ) {
    this.maker = new Maker(library, 'trace', (answer) => this.take(answer), fail, tellSlow);
  }

  run(scene: Sketch | string, options: Options, most = mostEvents): void {
    const request = requestOf(scene, options, most);
    this.asked = { request, options };
    this.maker.ask(request);
  }

  /**
   * Runs a scene that hardly differs from the last one, as in a drag, if the last run was quick. Its result is reported
   * before the call returns, so that it is seen a frame earlier than a worker's. Returns whether there is a result.
   */
  runAtOnce(scene: Sketch, options: Options): boolean {
    const { own, lastQuick, maker } = this;
    if (own === null || lastQuick === null || maker.isBusy || scene.curves !== null) return false;
    const request = requestOf(scene, options, mostAfter(lastQuick));
    const traced = this.taken(own.run(request, traceOf));
    if (traced.trace?.shortened) return false;
    this.tell(traced);
    return true;
  }

  private take({ made, ...outcome }: Outcome<Uint8Array>): void {
    const traced = this.taken({ ...outcome, made: made && traceOf(made) });
    this.tell(traced);
    // The page's own thread has no functions for surfaces.
    const isQuick = this.lastQuick !== null && traced.trace?.header.scene.curves === null;
    if (isQuick && this.prepared !== this.asked?.options) {
      requestAnimationFrame(() => setTimeout(() => void this.prepare().catch(this.fail)));
    }
  }

  /** Repeats the last run in the page's own thread: a first run takes several times as long as later ones. */
  private async prepare(): Promise<void> {
    const module = await moduleOf(this.library);
    const { asked, maker, lastQuick } = this;
    if (asked === null || maker.isBusy || lastQuick === null) return;
    this.own ??= new Library(module);
    this.own.run(asked.request, () => null);
    this.prepared = asked.options;
  }

  private taken({ made: trace, messages, milliseconds }: Outcome<Trace>): Traced {
    this.lastQuick = milliseconds <= quick ? (trace?.timeline.length ?? null) : null;
    return { trace, messages };
  }

  /** Cancels the current and the waiting run. */
  forget(): void {
    this.maker.forget();
  }
}
