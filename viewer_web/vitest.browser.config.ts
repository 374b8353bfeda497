import { defineConfig } from 'vitest/config';

/** The page as it was built, in a real browser. */
export default defineConfig({
  test: {
    include: ['browser/**/*.test.ts'],
    fileParallelism: false,
    testTimeout: 120_000,
    hookTimeout: 60_000,
    // A shared machine may stand still for seconds in the middle of a drag: then once more, and the report says so.
    retry: 1,
    // A slow machine needs longer than a second to draw.
    expect: { poll: { timeout: 30_000 } },
  },
});
