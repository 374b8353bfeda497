import { sha256 } from '@noble/hashes/sha2';

/** What vidno.wasm gives; `trace/wasm/live.cpp` documents it. */
interface Exports {
  readonly memory: WebAssembly.Memory;
  _initialize(): void;
  request(size: number): number;
  run(): number;
  trace(): number;
  trace_size(): number;
  messages(): number;
  messages_size(): number;
}

export interface Outcome {
  /** The trace's bytes; null if the request was refused. */
  readonly trace: Uint8Array<ArrayBuffer> | null;
  /** Why it was refused, or what there is to know about the scene: a line each. */
  readonly messages: string;
}

const nothing = (): number => 0;

/** The library compiled to WebAssembly: makes traces, with the same bytes as the program. */
export class Library {
  private readonly exports: Exports;

  constructor(module: WebAssembly.Module) {
    const { exports } = new WebAssembly.Instance(module, this.imports(module));
    this.exports = exports as unknown as Exports;
    this.exports._initialize();
  }

  run(request: string): Outcome {
    const bytes = new TextEncoder().encode(request);
    const at = this.exports.request(bytes.length);
    this.bytes(at, bytes.length).set(bytes);
    const ran = this.exports.run() !== 0;
    const { trace, trace_size, messages, messages_size } = this.exports;
    return {
      trace: ran ? this.bytes(trace(), trace_size()).slice() : null,
      messages: new TextDecoder().decode(this.bytes(messages(), messages_size())),
    };
  }

  /** Its standard library would also read and write files: there are none. */
  private imports(module: WebAssembly.Module): WebAssembly.Imports {
    const imports: Record<string, Record<string, WebAssembly.ImportValue>> = {};
    for (const { module: from, name } of WebAssembly.Module.imports(module)) {
      imports[from] = { ...imports[from], [name]: nothing };
    }
    const hash = (at: number, size: number, to: number): void =>
      this.bytes(to, 32).set(sha256(this.bytes(at, size)));
    return { ...imports, vidno: { sha256: hash } };
  }

  /** Never kept: the memory moves as it grows. */
  private bytes(at: number, size: number): Uint8Array<ArrayBuffer> {
    return new Uint8Array(this.exports.memory.buffer, at, size);
  }
}
