// replay.wasm as the page starts it.
import { readFileSync } from 'node:fs';

/** The module in a file: its functions, what it made last, and a trace that it reads. */
export function engineOf(file) {
  const compiled = new WebAssembly.Module(readFileSync(file));
  // The linker takes a function of ours that no object has for one of the page's.
  const missing = WebAssembly.Module.imports(compiled).filter(
    ({ module: from, name }) => from === 'env' && name !== 'emscripten_notify_memory_growth',
  );
  if (missing.length > 0) throw new Error(`not linked: ${missing.map(({ name }) => name).join(', ')}`);
  const nothing = new Proxy({}, { get: () => () => 0 });
  const { exports: wasm } = new WebAssembly.Instance(compiled, {
    env: nothing,
    wasi_snapshot_preview1: nothing,
  });
  wasm._initialize();

  const decoder = new TextDecoder();
  const bytes = (at, size) => new Uint8Array(wasm.memory.buffer, at, size);
  const made = () => decoder.decode(bytes(wasm.made(), wasm.made_size()));
  const messages = () => decoder.decode(bytes(wasm.messages(), wasm.messages_size()));

  /** Reads the file in pieces that end anywhere. */
  function opened(file) {
    const trace = wasm.trace_open();
    const piece = 1000;
    for (let from = 0; from < file.length; from += piece) {
      const part = file.subarray(from, from + piece);
      bytes(wasm.request(part.length), part.length).set(part);
      if (!wasm.trace_append(trace)) throw new Error(messages());
    }
    if (!wasm.trace_finish(trace)) throw new Error(messages());
    wasm.trace_shortened(trace);
    if (made() !== '') throw new Error(made());
    return trace;
  }
  return { wasm, made, opened };
}
