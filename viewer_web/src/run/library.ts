import { sha256 } from '@noble/hashes/sha2';
import { numberOf } from '../trace/events.js';
import type { EventName } from '../trace/events.js';
import { FormulaRefused, heightFunction } from './height-function.js';
import type { HeightFunction } from './height-function.js';

/** What vidno.wasm gives; `trace/wasm/live.cpp` documents it. */
interface Exports {
  readonly memory: WebAssembly.Memory;
  _initialize(): void;
  request(size: number): number;
  run(): number;
  map(): number;
  made(): number;
  made_size(): number;
  events(): number;
  starts(): number;
  names(): number;
  name(number: number): number;
  messages(): number;
  messages_size(): number;
}

/** A whole trace in bytes, and where its lines are. */
export interface MadeTrace {
  readonly bytes: Uint8Array<ArrayBuffer>;
  /** Where the line of each event begins, and then the last line. */
  readonly starts: Uint32Array<ArrayBuffer>;
  /** The number of each event's name. */
  readonly names: Uint8Array<ArrayBuffer>;
}

export interface Outcome<T> {
  /** Null if the request was refused. */
  readonly made: T | null;
  /** Why it was refused, or what there is to know about the scene: a line each. */
  readonly messages: string;
}

const nothing = (): number => 0;

/** The library compiled to WebAssembly: makes traces, with the same bytes as the program, and sign maps. */
export class Library {
  private readonly exports: Exports;
  private height: HeightFunction = () => NaN;
  /** For the library's numbers of events' names those of the page. */
  private readonly numbers: Uint8Array;

  constructor(module: WebAssembly.Module) {
    const { exports } = new WebAssembly.Instance(module, this.imports(module));
    this.exports = exports as unknown as Exports;
    this.exports._initialize();
    this.numbers = Uint8Array.from(this.names(), (name) => numberOf.get(name) ?? 255);
  }

  run(request: string): Outcome<MadeTrace> {
    const { run, made, made_size, events, starts, names } = this.exports;
    return this.outcome(request, run, () => {
      const count = events();
      const { buffer } = this.exports.memory;
      return {
        bytes: this.bytes(made(), made_size()).slice(),
        starts: new Uint32Array(buffer, starts(), count + 1).slice(),
        names: this.bytes(names(), count).map((number) => this.numbers[number] ?? 255),
      };
    });
  }

  /** A character a place; see `live.cpp`. */
  map(request: string): Outcome<string> {
    const { map, made, made_size } = this.exports;
    return this.outcome(request, map, () => this.text(made(), made_size()));
  }

  private outcome<T>(request: string, make: () => number, take: () => T): Outcome<T> {
    const bytes = new TextEncoder().encode(request);
    this.bytes(this.exports.request(bytes.length), bytes.length).set(bytes);
    const isMade = make() !== 0;
    const { messages, messages_size } = this.exports;
    return { made: isMade ? take() : null, messages: this.text(messages(), messages_size()) };
  }

  /** All names of events in the library's order. */
  private names(): readonly EventName[] {
    const found: EventName[] = [];
    for (let at = this.exports.name(0); at !== 0; at = this.exports.name(found.length)) {
      const rest = new Uint8Array(this.exports.memory.buffer, at);
      found.push(this.text(at, rest.indexOf(0)) as EventName);
    }
    return found;
  }

  /** Its standard library would also read and write files: there are none. */
  private imports(module: WebAssembly.Module): WebAssembly.Imports {
    const imports: Record<string, Record<string, WebAssembly.ImportValue>> = {};
    for (const { module: from, name } of WebAssembly.Module.imports(module)) {
      imports[from] = { ...imports[from], [name]: nothing };
    }
    const hash = (at: number, size: number, to: number): void =>
      this.bytes(to, 32).set(sha256(this.bytes(at, size)));
    const formula = (at: number, size: number, to: number, room: number): number =>
      this.take(this.text(at, size), this.bytes(to, room));
    const height = (x: number, z: number): number => this.height(x, z);
    return { ...imports, vidno: { sha256: hash, formula, height } };
  }

  /** Takes a function for the next surface, or writes why not; gives how many bytes that are. */
  private take(text: string, reason: Uint8Array): number {
    try {
      this.height = heightFunction(text);
      return 0;
    } catch (error) {
      if (!(error instanceof FormulaRefused)) throw error;
      return new TextEncoder().encodeInto(error.message, reason).written;
    }
  }

  private text(at: number, size: number): string {
    return new TextDecoder().decode(this.bytes(at, size));
  }

  /** Never kept: the memory moves as it grows. */
  private bytes(at: number, size: number): Uint8Array<ArrayBuffer> {
    return new Uint8Array(this.exports.memory.buffer, at, size);
  }
}
