import { fileIn } from '../base64.js';
import { starterOf } from '../trace/start-worker.js';
import { Trace } from '../trace/trace.js';
import type { Options } from './options.js';
import { sceneText } from './sketch.js';
import type { Sketch } from './sketch.js';
import type { Answer, Order } from './worker.js';
import code from './worker.js?code';

const startWorker = starterOf(code);

/** A longer run is partial: the page shows its beginning. */
const mostEvents = 1_000_000;
/** Milliseconds after which a run is given up for a newer one. */
const patience = 1000;

/** What came of a run. */
export interface Traced {
  /** None if the scene or the way to run it was refused. */
  readonly trace: Trace | null;
  readonly messages: string;
}

/** The library that the page brings along, packed, as a block of data; null if it was built without. */
export function embeddedLibrary(page: Document): Blob | null {
  const block = page.getElementById('vidno-library');
  return block && fileIn(block);
}

async function compiled(packed: Blob): Promise<WebAssembly.Module> {
  const bytes = packed.stream().pipeThrough(new DecompressionStream('gzip'));
  return WebAssembly.compile(await new Response(bytes).arrayBuffer());
}

/** Runs scenes in a worker, one at a time. Of those that wait only the newest is run. */
export class Tracer {
  private worker: Worker | null = null;
  private module: Promise<WebAssembly.Module> | null = null;
  private turn = 0;
  private running: { readonly turn: number; readonly since: number } | null = null;
  private waiting: string | null = null;

  constructor(
    private readonly library: Blob,
    private readonly tell: (traced: Traced) => void,
    private readonly fail: (error: unknown) => void,
  ) {}

  run(scene: Sketch | string, options: Options): void {
    const file = typeof scene === 'string' ? scene : sceneText(scene);
    this.waiting = `${JSON.stringify({ ...options, most_events: mostEvents })}\n${file}`;
    const { running } = this;
    if (running !== null && performance.now() - running.since > patience) this.stop();
    if (this.running === null) this.next();
  }

  /** What runs and what waits is forgotten. */
  forget(): void {
    this.waiting = null;
    if (this.running !== null) this.stop();
  }

  private stop(): void {
    this.worker?.terminate();
    this.worker = null;
    this.running = null;
  }

  private next(): void {
    this.running = { turn: ++this.turn, since: performance.now() };
    void this.send(this.turn).catch(this.fail);
  }

  private async send(turn: number): Promise<void> {
    this.module ??= compiled(this.library);
    const module = await this.module;
    if (this.running?.turn !== turn || this.waiting === null) return;
    this.worker ??= this.started(module);
    this.running = { turn, since: performance.now() };
    const request = this.waiting;
    this.waiting = null;
    this.worker.postMessage({ turn, request } satisfies Order);
  }

  private started(library: WebAssembly.Module): Worker {
    const worker = startWorker();
    worker.onmessage = ({ data }: MessageEvent<Answer>): void => this.take(data);
    worker.onerror = this.fail;
    worker.postMessage({ library } satisfies Order);
    return worker;
  }

  private take({ turn, messages, made }: Answer): void {
    if (this.running?.turn !== turn) return;
    this.running = null;
    if (this.waiting !== null) this.next();
    let trace: Trace | null = null;
    if (made !== null) {
      const { header, blocks, end } = made;
      trace = new Trace(header);
      for (const block of blocks) trace.add({ is: 'part', block, keyframes: [], read: 1 });
      const partial = end.partial === true;
      const shortened = partial ? { why: 'partial' as const, line: end.events + 1 } : null;
      trace.add({ is: 'end', end, shortened });
    }
    this.tell({ trace, messages });
  }
}
