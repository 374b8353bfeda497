import { defineConfig } from 'vite';
import { singleFile } from './plugins/single-file.js';
import { version } from './plugins/version.js';

/** The page of cost against error. It is built separately, because each page must be a single script. */
export default defineConfig({
  plugins: [version(), singleFile('chart.html')],
  build: {
    target: 'es2022',
    modulePreload: false,
    chunkSizeWarningLimit: 2000,
    emptyOutDir: false,
    rollupOptions: { input: 'chart.html' },
  },
});
