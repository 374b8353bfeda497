import { defineConfig } from 'vite';
import { singleFile } from './plugins/single-file.js';

/** The page of cost against error. It is built separately, because each page must be a single script. */
export default defineConfig({
  plugins: [singleFile('chart.html')],
  build: {
    target: 'es2022',
    modulePreload: false,
    chunkSizeWarningLimit: 2000,
    emptyOutDir: false,
    rollupOptions: { input: 'chart.html' },
  },
});
