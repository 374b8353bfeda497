import { numberOf } from '../trace/events.js';
import type { EventName } from '../trace/events.js';

/** The exports of vidno.wasm that all its uses need; `trace/wasm/live.cpp` documents them. */
export interface Basics {
  readonly memory: WebAssembly.Memory;
  _initialize(): void;
  request(size: number): number;
  events(): number;
  starts(): number;
  names(): number;
  name(number: number): number;
}

/** The positions of the lines of events in bytes. */
export interface LinesFound {
  /** The start of each event's line, followed by the start of the line after them. */
  readonly starts: Uint32Array<ArrayBuffer>;
  /** The number of each event's name. */
  readonly names: Uint8Array<ArrayBuffer>;
}

const nothing = (): number => 0;

/** The compiled library, with its own memory. */
export class Instance<E extends Basics> {
  readonly exports: E;
  /** Maps the library's numbers of event names to those of the page. */
  private readonly numbers: Uint8Array;

  /** The library calls the functions of `own`. */
  constructor(module: WebAssembly.Module, own: WebAssembly.ModuleImports = {}) {
    const { exports } = new WebAssembly.Instance(module, importsOf(module, own));
    this.exports = exports as unknown as E;
    this.exports._initialize();
    this.numbers = Uint8Array.from(this.names(), (name) => numberOf.get(name) ?? 255);
  }

  /** Writes the next request to the library. */
  ask(request: Uint8Array): void {
    this.bytes(this.exports.request(request.length), request.length).set(request);
  }

  lines(): LinesFound {
    const { memory, events, starts, names } = this.exports;
    const count = events();
    const found = this.bytes(names(), count).slice();
    // A loop, because `map` takes several times as long.
    for (let i = 0; i < count; i++) found[i] = this.numbers[found[i] ?? 255] ?? 255;
    return { starts: new Uint32Array(memory.buffer, starts(), count + 1).slice(), names: found };
  }

  text(at: number, size: number): string {
    return new TextDecoder().decode(this.bytes(at, size));
  }

  /** A view of the memory. It must not be kept, because the memory moves as it grows. */
  bytes(at: number, size: number): Uint8Array<ArrayBuffer> {
    return new Uint8Array(this.exports.memory.buffer, at, size);
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
}

/** The library's standard library also imports functions for files, of which there are none. */
function importsOf(
  module: WebAssembly.Module,
  own: WebAssembly.ModuleImports,
): WebAssembly.Imports {
  const imports: Record<string, Record<string, WebAssembly.ImportValue>> = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module)) {
    imports[from] = { ...imports[from], [name]: nothing };
  }
  return { ...imports, vidno: { ...imports['vidno'], ...own } };
}
