import { defineConfig } from 'vite';
import { engine } from './plugins/engine.js';
import { licensed } from './plugins/licensed.js';

/** The questions of a trace for Moodle, as one script that Node runs. */
export default defineConfig({
  plugins: [engine(), licensed()],
  // The script needs only Lit's style sheet syntax.
  resolve: { alias: { lit: '@lit/reactive-element/css-tag.js' } },
  ssr: { noExternal: true },
  build: {
    target: 'node18',
    emptyOutDir: false,
    ssr: 'src/app/questions.ts',
    rollupOptions: { output: { entryFileNames: 'vidno-questions.mjs' } },
  },
});
