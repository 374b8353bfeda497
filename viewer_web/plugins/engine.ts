import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import type { Plugin } from 'vite';
import { packed } from './packed.js';

const name = 'virtual:vidno-engine';

/** `import engine from 'virtual:vidno-engine'` gives the module that replays traces, packed as text: the page is one file. */
export function engine(): Plugin {
  const file = process.env['VIDNO_REPLAY_WASM'] ?? '../build/release/trace/wasm/replay.wasm';
  return {
    name: 'vidno-engine',
    resolveId: (id) => (id === name ? `\0${name}` : null),
    load: (id) =>
      id === `\0${name}` ? `export default '${packed(readFileSync(resolve(file)))}';` : null,
  };
}
