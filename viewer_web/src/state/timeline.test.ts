import { describe, expect, it } from 'vitest';
import { headerOf } from '../testing/traces.js';
import { parseHeader } from '../trace/header.js';
import { canonical } from './canonical.js';
import { Timeline } from './timeline.js';

const header = parseHeader(headerOf('warnock', 'windows'));
const length = 100_000;

/** Each step paints one pixel, so that every step has its own picture. */
function longTimeline(): Timeline {
  const timeline = new Timeline(header);
  for (let i = 0; i < length; i++) {
    const x = i % 8;
    const y = Math.floor(i / 8) % 8;
    const color = `#${i.toString(16).padStart(6, '0')}`;
    timeline.append({ e: 'fill', at: 'W8', rect: [x, y, 1, 1], color });
  }
  return timeline;
}

describe('a long run', () => {
  const timeline = longTimeline();

  it('is at any step what its last pixel says', () => {
    for (let i = 0; i < 200; i++) {
      const step = 1 + ((i * 48_611) % length);
      const { picture } = canonical(timeline.seek(step), header) as { picture: readonly string[] };
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
