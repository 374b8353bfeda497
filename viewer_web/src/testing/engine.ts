/** Tests replay traces with the module that the build has compiled. */
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { ready, startEngine } from '../replay/engine.js';

const built = new URL('../../../build/release/trace/wasm/replay.wasm', import.meta.url);
const file = process.env['VIDNO_REPLAY_WASM'] ?? fileURLToPath(built);

// The test files of a process share the engine.
await ready().catch(() => {
  startEngine(WebAssembly.compile(readFileSync(file)));
  return ready();
});
