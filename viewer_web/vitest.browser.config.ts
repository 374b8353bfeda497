import { availableParallelism } from 'node:os';
import { defineConfig } from 'vitest/config';

/** What measures time: nothing else runs meanwhile. */
const timed = ['frame', 'history-speed', 'million', 'pauses'].map(
  (name) => `browser/${name}.test.ts`,
);

/** The page as it was built, in a real browser. */
export default defineConfig({
  test: {
    setupFiles: ['browser/setup.ts'],
    maxWorkers: availableParallelism(),
    minWorkers: 1,
    // The files that a process runs share its browser.
    isolate: false,
    testTimeout: 300_000,
    hookTimeout: 60_000,
    // A shared machine may stand still for seconds in the middle of a drag: then once more, and the report says so.
    retry: 1,
    // A slow machine needs longer than a second to draw.
    expect: { poll: { timeout: 30_000 } },
    projects: [
      {
        extends: true,
        test: { name: 'page', include: ['browser/**/*.test.ts'], exclude: timed },
      },
      {
        extends: true,
        test: {
          name: 'time',
          include: timed,
          isolate: true,
          poolOptions: { forks: { singleFork: true } },
          sequence: { groupOrder: 1 },
        },
      },
    ],
  },
});
