import { defineConfig } from 'vite';
import { licensed } from './plugins/licensed.js';

/** The functions of surfaces, for the npm package `vidno`, as one script that Node runs. */
export default defineConfig({
  plugins: [licensed([])],
  ssr: { noExternal: true },
  build: {
    target: 'node18',
    emptyOutDir: false,
    minify: true,
    ssr: 'src/run/height-function.ts',
    rollupOptions: { output: { entryFileNames: 'vidno-formula.mjs' } },
  },
});
