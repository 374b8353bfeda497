import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: {
    include: ['src/**/*.test.ts'],
    setupFiles: ['src/testing/algorithms.ts'],
    // The files that a process runs share what they import.
    isolate: false,
  },
  server: { fs: { allow: ['..'] } },
});
