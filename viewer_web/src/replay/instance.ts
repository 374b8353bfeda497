/** The exports that all modules of the library have; `trace/wasm/exchange.cpp` documents them. */
export interface Basics {
  readonly memory: WebAssembly.Memory;
  _initialize(): void;
  request(size: number): number;
  made(): number;
  made_size(): number;
  messages(): number;
  messages_size(): number;
}

const nothing = (): number => 0;

/** A compiled module of the library, with its own memory. */
export class Instance<E extends Basics> {
  readonly exports: E;
  private readonly decoder = new TextDecoder();

  /** The library calls the functions of `own`. */
  constructor(module: WebAssembly.Module, own: WebAssembly.ModuleImports = {}) {
    const { exports } = new WebAssembly.Instance(module, importsOf(module, own));
    this.exports = exports as unknown as E;
    this.exports._initialize();
  }

  /** Writes the next request. */
  ask(request: Uint8Array): void {
    this.bytes(this.exports.request(request.length), request.length).set(request);
  }

  /** The bytes that the last call made. */
  madeBytes(): Uint8Array<ArrayBuffer> {
    return this.bytes(this.exports.made(), this.exports.made_size());
  }

  made(): string {
    return this.decoder.decode(this.madeBytes());
  }

  /** Why the last request was refused, or notes about it. */
  messages(): string {
    return this.text(this.exports.messages(), this.exports.messages_size());
  }

  text(at: number, size: number): string {
    return this.decoder.decode(this.bytes(at, size));
  }

  /** A view of the memory. It must not be kept, because the memory moves as it grows. */
  bytes(at: number, size: number): Uint8Array<ArrayBuffer> {
    return new Uint8Array(this.exports.memory.buffer, at, size);
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
