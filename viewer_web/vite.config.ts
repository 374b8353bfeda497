import { resolve } from 'node:path';
import { defineConfig } from 'vite';
import { lessons } from './plugins/lessons.js';
import { singleFile } from './plugins/single-file.js';
import { workerCode } from './plugins/worker-code.js';

const traces = process.env['VIDNO_TRACES'] ?? '../build/lessons';

export default defineConfig({
  plugins: [workerCode(), lessons(resolve(traces)), singleFile('index.html')],
  server: { fs: { allow: ['..'] } },
  build: {
    target: 'es2022',
    modulePreload: false,
    chunkSizeWarningLimit: 2000,
  },
});
