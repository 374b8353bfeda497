import { describe, expect, it } from 'vitest';
import { headerOf, textWith, traceOf } from '../testing/traces.js';
import type { Event } from '../trace/events.js';
import { canonical } from './canonical.js';

const length = 100_000;

/** Each step paints one pixel, so that every step has its own picture. */
const fills = Array.from({ length }, (_, i): Event => {
  const rect = [i % 8, Math.floor(i / 8) % 8, 1, 1] as const;
  return { e: 'fill', at: 'W8', rect, color: `#${i.toString(16).padStart(6, '0')}` };
});

describe('a long run', async () => {
  const { header, timeline } = await traceOf(textWith(headerOf('warnock', 'windows'), fills));

  it('is at any step what its last pixel says', () => {
    for (let i = 0; i < 200; i++) {
      const step = 1 + ((i * 48_611) % length);
      const { picture } = canonical(timeline.seek(step), header, []) as {
        picture: readonly string[];
      };
      const index = step - 1;
      const row = picture[Math.floor(index / 8) % 8] ?? '';
      const pixel = row.slice(7 * (index % 8), 7 * (index % 8) + 7);
      expect(pixel).toBe(`#${index.toString(16).padStart(6, '0')}`);
    }
  });

  it('goes back as fast as forward', () => {
    const start = performance.now();
    for (let step = 60_000; step > 59_000; step--) timeline.seek(step);
    expect((performance.now() - start) / 1000).toBeLessThan(4);
  });
});
