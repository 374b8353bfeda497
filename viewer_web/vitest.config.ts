import { availableParallelism } from 'node:os';
import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: {
    include: ['src/**/*.test.ts'],
    setupFiles: ['src/app/algorithms.ts', 'src/testing/engine.ts', 'src/testing/streams.ts'],
    // By default, one processor stays idle.
    maxWorkers: availableParallelism(),
    minWorkers: 1,
    // The test files in a process share their imported modules.
    isolate: false,
    // A slow machine, busy with other tests, needs longer than the usual five seconds.
    testTimeout: 60_000,
  },
  server: { fs: { allow: ['..'] } },
});
