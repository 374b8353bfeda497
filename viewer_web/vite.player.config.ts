import { defineConfig } from 'vite';
import type { Rollup } from 'vite';
import { licensed } from './plugins/licensed.js';
import { workerCode } from './plugins/worker-code.js';

const workers: Rollup.OutputChunk[] = [];

/** The player as one script for other pages, which defines the element `vidno-player`. */
export default defineConfig({
  plugins: [workerCode(workers), licensed(workers)],
  build: {
    target: 'es2022',
    emptyOutDir: false,
    lib: {
      entry: 'src/app/player.ts',
      formats: ['iife'],
      name: 'vidno',
      fileName: () => 'vidno-player.js',
    },
  },
});
