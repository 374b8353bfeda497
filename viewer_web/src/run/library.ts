import { sha256 } from '@noble/hashes/sha2';
import { Instance } from '../replay/instance.js';
import type { Basics } from '../replay/instance.js';

/** The exports of vidno.wasm; `trace/wasm/live.cpp` documents them. */
interface Exports extends Basics {
  run(): number;
  map(): number;
  findings(): number;
  margin(): number;
  scene(): number;
  failure(): number;
}

/** A request as a text, or as bytes where it contains a file that is no text; see `live.cpp`. */
export type Request = string | Uint8Array<ArrayBuffer>;

export interface Outcome<T> {
  /** Null if the request was refused. */
  readonly made: T | null;
  /** Why it was refused, or notes about the scene, one per line. */
  readonly messages: string;
  /** How long it took. */
  readonly milliseconds: number;
}

/** Makes traces, byte for byte those of the program, and sign maps. */
export class Library {
  private readonly instance: Instance<Exports>;

  constructor(module: WebAssembly.Module) {
    this.instance = new Instance<Exports>(module, {
      sha256: (at: number, size: number, to: number): void =>
        this.instance.bytes(to, 32).set(sha256(this.instance.bytes(at, size))),
    });
  }

  /**
   * Makes a trace. `take` gets its bytes in the library's memory, which the next request overwrites.
   */
  run<T>(request: Request, take: (bytes: Uint8Array<ArrayBuffer>) => T): Outcome<T> {
    return this.outcome(request, this.instance.exports.run, () => take(this.instance.madeBytes()));
  }

  /** One character per place; see `live.cpp`. */
  map(request: Request): Outcome<string> {
    return this.textOf(request, this.instance.exports.map);
  }

  /** The list of a run's decisions, `vidno-decisions/1`. */
  findings(request: Request): Outcome<string> {
    return this.textOf(request, this.instance.exports.findings);
  }

  /** The region to which a vertex may be moved, `vidno-margin/1`. */
  margin(request: Request): Outcome<string> {
    return this.textOf(request, this.instance.exports.margin);
  }

  /** The scene of a mesh; the messages are what it lacks. */
  scene(request: Request): Outcome<string> {
    return this.textOf(request, this.instance.exports.scene);
  }

  /** The description of a failure as JSON; see `live.cpp`. */
  failure(request: Request): Outcome<string> {
    return this.textOf(request, this.instance.exports.failure);
  }

  private textOf(request: Request, make: () => number): Outcome<string> {
    return this.outcome(request, make, () => this.instance.made());
  }

  private outcome<T>(request: Request, make: () => number, take: () => T): Outcome<T> {
    const { instance } = this;
    instance.ask(typeof request === 'string' ? new TextEncoder().encode(request) : request);
    const start = performance.now();
    const isMade = make() !== 0;
    const milliseconds = performance.now() - start;
    return { made: isMade ? take() : null, messages: instance.messages(), milliseconds };
  }
}
