// `vidno trace` and `vidno import` with vidno.wasm, the library that the page uses.
//
//     node vidno.mjs VIDNO.wasm trace SCENE [--method M] [--kernel K] [--edition E] [--detail D] [--check] -o FILE
//     node vidno.mjs VIDNO.wasm import MESH [FILE that it names]... -o FILE
import { createHash } from 'node:crypto';
import { readFileSync, writeFileSync } from 'node:fs';
import { basename } from 'node:path';
import { parseArgs } from 'node:util';

const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: {
    method: { type: 'string', default: 'warnock' },
    kernel: { type: 'string', default: 'double' },
    edition: { type: 'string', default: 'corrected' },
    detail: { type: 'string', default: 'signs' },
    check: { type: 'boolean', default: false },
    output: { type: 'string', short: 'o' },
  },
});
const [module, command, ...files] = positionals;
const { output, ...options } = values;

const bytes = (at, size) => new Uint8Array(wasm.memory.buffer, at, size);
const compiled = new WebAssembly.Module(readFileSync(module));
// The linker takes a function of ours that no object has for one of the page's.
const missing = WebAssembly.Module.imports(compiled).filter(
  ({ module: from, name }) => from === 'env' && name !== 'emscripten_notify_memory_growth',
);
if (missing.length > 0) throw new Error(`not linked: ${missing.map(({ name }) => name).join(', ')}`);
const nothing = new Proxy({}, { get: () => () => 0 });
const instance = await WebAssembly.instantiate(compiled, {
  env: nothing,
  wasi_snapshot_preview1: nothing,
  vidno: {
    sha256: (at, size, to) =>
      bytes(to, 32).set(createHash('sha256').update(bytes(at, size)).digest()),
  },
});
const wasm = instance.exports;
wasm._initialize();

const contents = files.map((file) => readFileSync(file));
const asked =
  command === 'import'
    ? { files: files.map((file, i) => ({ name: basename(file), size: contents[i].length })) }
    : { ...options, most_events: 2 ** 31 - 1 };
const request = Buffer.concat([Buffer.from(`${JSON.stringify(asked)}\n`), ...contents]);
bytes(wasm.request(request.length), request.length).set(request);
const ran = command === 'import' ? wasm.scene() : wasm.run();
process.stderr.write(bytes(wasm.messages(), wasm.messages_size()));
if (!ran) process.exit(2);
writeFileSync(output, bytes(wasm.made(), wasm.made_size()));
