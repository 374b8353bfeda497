import { defineConfig } from 'vite';
import { engine } from './plugins/engine.js';
import { licensed } from './plugins/licensed.js';

/** The player as one script for other pages, which defines the element `vidno-player`. */
export default defineConfig({
  plugins: [engine(), licensed()],
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
