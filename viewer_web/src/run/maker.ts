import { fileIn } from '../base/base64.js';
import { ready } from '../replay/engine.js';
import type { Request } from './library.js';
import type { Answer, Makes, Order, What } from './worker.js';
import code from './worker.js?code';

type Vouch = (address: string) => unknown;
interface Vouching {
  createPolicy(name: string, rules: { createScriptURL: Vouch }): { createScriptURL: Vouch };
}

/** Some policies accept only addresses of scripts from a trusted source. The only one here is the page's own text. */
const { trustedTypes } = globalThis as { readonly trustedTypes?: Vouching };
const vouched = trustedTypes?.createPolicy('vidno-worker', {
  createScriptURL: (address) => address,
});

// Kept for the next worker: a browser may read the address only after the worker was created.
const own = URL.createObjectURL(new Blob([code], { type: 'text/javascript' }));

/** Starts a worker with the script in the page's own text. */
const startWorker = (): Worker => new Worker((vouched?.createScriptURL(own) ?? own) as string);

/** Milliseconds after which work is cancelled in favour of a newer request. */
const patience = 1000;
/** Milliseconds after which a reader wants to know that there is work. */
const quiet = 500;

/** The page's library, a packed block of data; null if the page was built without it. */
export function embeddedLibrary(page: Document): Blob | null {
  const block = page.getElementById('vidno-library');
  return block && fileIn(block);
}

async function compiled(packed: Blob): Promise<WebAssembly.Module> {
  const bytes = packed.stream().pipeThrough(new DecompressionStream('gzip'));
  return WebAssembly.compile(await new Response(bytes).arrayBuffer());
}

const modules = new WeakMap<Blob, Promise<WebAssembly.Module>>();

/** The compiled library, shared by all its users because compiling takes a while. */
export function moduleOf(library: Blob): Promise<WebAssembly.Module> {
  const module = modules.get(library) ?? compiled(library);
  modules.set(library, module);
  return module;
}

/** Makes results in a worker with the library, one at a time. Only the newest of the waiting requests is served. */
export class Maker<W extends What> {
  private worker: Worker | null = null;
  private turn = 0;
  private running: { readonly turn: number; readonly since: number } | null = null;
  private waiting: Request | null = null;

  constructor(
    private readonly library: Blob,
    private readonly what: W,
    private readonly tell: (answer: Answer<W>) => void,
    private readonly fail: (error: unknown) => void,
    /** Called when a request takes long. */
    private readonly tellSlow: () => void = () => undefined,
  ) {}

  get isBusy(): boolean {
    return this.running !== null;
  }

  ask(request: Request): void {
    this.waiting = request;
    const { running } = this;
    if (running !== null && performance.now() - running.since > patience) this.stop();
    if (this.running === null) this.next();
  }

  /** Cancels the current and the waiting request. */
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
    const module = await moduleOf(this.library);
    // Replays what the library makes.
    await ready();
    if (this.running?.turn !== turn || this.waiting === null) return;
    this.worker ??= this.started(module);
    this.running = { turn, since: performance.now() };
    const request = this.waiting;
    this.waiting = null;
    this.worker.postMessage({ turn, what: this.what, request } satisfies Order);
    setTimeout(() => {
      if (this.running?.turn === turn) this.tellSlow();
    }, quiet);
  }

  private started(library: WebAssembly.Module): Worker {
    const worker = startWorker();
    worker.onmessage = ({ data }: MessageEvent<Answer<W>>): void => this.take(data);
    worker.onerror = this.fail;
    worker.postMessage({ library } satisfies Order);
    return worker;
  }

  private take(answer: Answer<W>): void {
    if (this.running?.turn !== answer.turn) return;
    this.running = null;
    if (this.waiting !== null) this.next();
    this.tell(answer);
  }
}

/** A result, or why there is none; both are missing if the library itself failed. */
export interface Made<W extends What> {
  readonly made: Makes[W] | null;
  readonly messages: string;
}

/** Makes results for those who wait for them. A result never comes if another one is asked for meanwhile. */
export class Promised<W extends What> {
  private readonly maker: Maker<W>;
  private tell: ((made: Made<W>) => void) | null = null;

  constructor(library: Blob, what: W) {
    this.maker = new Maker(
      library,
      what,
      (answer) => this.take(answer),
      () => this.take({ made: null, messages: '' }),
    );
  }

  ask(request: Request): Promise<Made<W>> {
    return new Promise((tell) => {
      this.tell = tell;
      this.maker.ask(request);
    });
  }

  private take(made: Made<W>): void {
    if (this.maker.isBusy) return;
    this.tell?.(made);
    this.tell = null;
  }
}
