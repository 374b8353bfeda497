import { Trace } from '../replay/trace.js';
import { Maker } from './maker.js';
import type { Options } from './options.js';
import { sceneText } from './sketch.js';
import type { Sketch } from './sketch.js';
import type { Makes } from './worker.js';

/** A longer run is partial: the page shows its beginning. */
const mostEvents = 1_000_000;

/** The result of a run. */
export interface Traced {
  /** Null if the scene or the options were refused. */
  readonly trace: Trace | null;
  readonly messages: string;
}

/** Runs scenes, one at a time. Only the newest of the waiting scenes is run. */
export class Tracer {
  private readonly maker: Maker<'trace'>;

  constructor(library: Blob, tell: (traced: Traced) => void, fail: (error: unknown) => void) {
    this.maker = new Maker(
      library,
      'trace',
      ({ made, messages }) => tell({ trace: made && traceOf(made), messages }),
      fail,
    );
  }

  run(scene: Sketch | string, options: Options, most = mostEvents): void {
    const file = typeof scene === 'string' ? scene : sceneText(scene);
    this.maker.ask(`${JSON.stringify({ ...options, most_events: most })}\n${file}`);
  }

  /** Cancels the current and the waiting run. */
  forget(): void {
    this.maker.forget();
  }
}

function traceOf({ header, blocks, end }: Makes['trace']): Trace {
  const trace = new Trace(header);
  for (const block of blocks) trace.add({ is: 'part', block, read: 1 });
  const isPartial = end.partial === true;
  const shortened = isPartial ? { why: 'partial' as const, line: end.events + 1 } : null;
  trace.add({ is: 'end', end, shortened });
  return trace;
}
