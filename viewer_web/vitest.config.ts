import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: {
    include: ['src/**/*.test.ts'],
    setupFiles: ['src/testing/algorithms.ts'],
    // The test files in a process share their imported modules.
    isolate: false,
  },
  server: { fs: { allow: ['..'] } },
});
