import { describe, expect, it, vi } from 'vitest';
import { bareTimelineOf, headerOf, textWith, traceOf } from '../testing/traces.js';
import type { Event } from '../trace/events.js';
import { Store } from '../trace/store.js';
import { canonical } from './canonical.js';
import { toPixel } from './grid.js';
import type { Timeline } from './timeline.js';

const length = 100_000;

/** Each step paints one pixel, so every step has a different picture. */
const fills = Array.from({ length }, (_, i): Event => {
  const rect = [i % 8, Math.floor(i / 8) % 8, 1, 1] as const;
  return { e: 'fill', at: 'W8', rect, color: `#${i.toString(16).padStart(6, '0')}` };
});

/** Whether the pixel of the last step is painted. */
const isPainted = (timeline: Timeline, step: number): boolean =>
  timeline.seek(step).screen.picture.at((step - 1) % 8, ((step - 1) >> 3) % 8) ===
  toPixel(`#${(step - 1).toString(16).padStart(6, '0')}`);

/** The number of events read for a seek. */
function looksOf(timeline: Timeline, step: number): number {
  const look = vi.spyOn(Store.prototype, 'event');
  timeline.seek(step);
  const { length } = look.mock.calls;
  look.mockRestore();
  return length;
}

describe('a long seek', { timeout: 20_000 }, () => {
  const text = textWith(headerOf('warnock', 'windows'), fills);
  const fresh = (): Promise<Timeline> => bareTimelineOf(text);

  it('is done in parts, while the state stays where it is', async () => {
    const timeline = await fresh();
    const { values, screen } = timeline.seek(5);
    const before = screen.picture.row(0).slice();
    const lefts = [timeline.approach(length, 0)];
    while (lefts.at(-1) !== 0 && lefts.length < length) lefts.push(timeline.approach(length, 0.01));
    expect(lefts.length).toBeGreaterThan(10);
    expect(lefts).toEqual([...new Set(lefts)].sort((a, b) => b - a));
    expect(screen.picture.row(0)).toEqual(before);
    expect(values.step).toBe(5);
    expect(looksOf(timeline, length)).toBeLessThan(4000);
    expect(isPainted(timeline, length)).toBe(true);
    // A few steps back are near, too.
    expect(looksOf(timeline, length - 1)).toBeLessThan(4000);
  });

  it('may change its goal before its end', async () => {
    const timeline = await fresh();
    expect(timeline.approach(length, 0)).toBeGreaterThan(0);
    expect(timeline.approach(100, 0)).toBe(0);
    for (const step of [100, 70_000, 60_001, length]) expect(isPainted(timeline, step)).toBe(true);
  });

  it('is not needed once the run was replayed', async () => {
    const timeline = await fresh();
    expect(timeline.ripen(0)).toBe(false);
    expect(timeline.ripen()).toBe(true);
    for (let i = 1; i <= 50; i++) {
      const step = 1 + ((i * 48_611) % length);
      expect(timeline.approach(step, 0)).toBe(0);
      // 100 000 steps have keyframes at a distance of 256.
      expect(looksOf(timeline, step)).toBeLessThanOrEqual(256 + 1);
      expect(isPainted(timeline, step)).toBe(true);
    }
  });
});

describe('a long run', async () => {
  const { header, timeline } = await traceOf(textWith(headerOf('warnock', 'windows'), fills));

  it('has at any step the right last pixel', () => {
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
