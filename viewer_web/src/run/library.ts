import { sha256 } from '@noble/hashes/sha2';
import { Instance } from '../replay/instance.js';
import type { Basics, LinesFound } from '../replay/instance.js';

/** The exports of vidno.wasm; `trace/wasm/live.cpp` documents them. */
interface Exports extends Basics {
  run(): number;
  map(): number;
  findings(): number;
  margin(): number;
  failure(): number;
  made(): number;
  made_size(): number;
  messages(): number;
  messages_size(): number;
}

/** A whole trace in bytes, and the positions of its lines. */
export interface MadeTrace extends LinesFound {
  readonly bytes: Uint8Array<ArrayBuffer>;
}

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

  /** Makes a trace; `copy` takes its bytes out of the library's memory, which the next request overwrites. */
  run(
    request: string,
    copy = (bytes: Uint8Array): Uint8Array<ArrayBuffer> => bytes.slice(),
  ): Outcome<MadeTrace> {
    const { instance } = this;
    const { run, made, made_size } = instance.exports;
    return this.outcome(request, run, () => ({
      bytes: copy(instance.bytes(made(), made_size())),
      ...instance.lines(),
    }));
  }

  /** One character per place; see `live.cpp`. */
  map(request: string): Outcome<string> {
    const { map, made, made_size } = this.instance.exports;
    return this.outcome(request, map, () => this.instance.text(made(), made_size()));
  }

  /** The list of a run's decisions, `vidno-decisions/1`. */
  findings(request: string): Outcome<string> {
    const { findings, made, made_size } = this.instance.exports;
    return this.outcome(request, findings, () => this.instance.text(made(), made_size()));
  }

  /** The region to which a vertex may be moved, `vidno-margin/1`. */
  margin(request: string): Outcome<string> {
    const { margin, made, made_size } = this.instance.exports;
    return this.outcome(request, margin, () => this.instance.text(made(), made_size()));
  }

  /** The description of a failure as JSON; see `live.cpp`. */
  failure(request: string): Outcome<string> {
    const { failure, made, made_size } = this.instance.exports;
    return this.outcome(request, failure, () => this.instance.text(made(), made_size()));
  }

  private outcome<T>(request: string, make: () => number, take: () => T): Outcome<T> {
    const { instance } = this;
    instance.ask(new TextEncoder().encode(request));
    const start = performance.now();
    const isMade = make() !== 0;
    const milliseconds = performance.now() - start;
    const { messages, messages_size } = instance.exports;
    return {
      made: isMade ? take() : null,
      messages: instance.text(messages(), messages_size()),
      milliseconds,
    };
  }
}
