import { resolve } from 'node:path';
import { defineConfig } from 'vite';
import type { Rollup } from 'vite';
import { atlas } from './plugins/atlas.js';
import { engine } from './plugins/engine.js';
import { library } from './plugins/library.js';
import { lessons } from './plugins/lessons.js';
import { singleFile } from './plugins/single-file.js';
import { version } from './plugins/version.js';
import { workerCode } from './plugins/worker-code.js';

const traces = process.env['VIDNO_TRACES'] ?? '../build/lessons';
const wasm = process.env['VIDNO_WASM'] ?? '../build/release/trace/wasm/vidno.wasm';

const workers: Rollup.OutputChunk[] = [];

export default defineConfig({
  plugins: [
    version(),
    workerCode(workers),
    engine(),
    lessons(resolve(traces)),
    library(resolve(wasm)),
    atlas(resolve('../lessons/failures')),
    singleFile('index.html', workers),
  ],
  server: { fs: { allow: ['..'] } },
  build: {
    target: 'es2022',
    modulePreload: false,
    chunkSizeWarningLimit: 2000,
  },
});
