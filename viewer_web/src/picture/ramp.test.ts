import { describe, expect, it } from 'vitest';
import { colorAt, stops } from './ramp.js';

/** CIE L* of a colour, from the definitions of sRGB (IEC 61966-2-1) and of CIELAB. */
function lightness(color: string): number {
  const [r = 0, g = 0, b = 0] = [1, 3, 5]
    .map((at) => Number.parseInt(color.slice(at, at + 2), 16) / 255)
    .map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
  const y = 0.2126 * r + 0.7152 * g + 0.0722 * b;
  return y > (6 / 29) ** 3 ? 116 * Math.cbrt(y) - 16 : (y * 116 * (29 / 6) ** 2) / 3;
}

describe('the ramp', () => {
  it('rises in lightness, in even steps', () => {
    const levels = stops.map(lightness);
    const [first = 0, last = 0] = [levels[0], levels.at(-1)];
    const even = (last - first) / (stops.length - 1);
    levels.slice(1).forEach((level, i) => {
      expect((level - (levels[i] ?? 0)) / even).toBeGreaterThan(0.75);
      expect((level - (levels[i] ?? 0)) / even).toBeLessThan(1.25);
    });
    expect(last - first).toBeGreaterThan(70);
  });

  it('passes through its colours, and ends with them', () => {
    expect([0, 0.5, 1].map(colorAt)).toEqual(['#440154', '#21918c', '#fde725']);
    expect([-3, 7].map(colorAt)).toEqual(['#440154', '#fde725']);
    // Halfway from 44 01 54 to 47 2d 7b.
    expect(colorAt(1 / 16)).toBe('#461768');
  });
});
