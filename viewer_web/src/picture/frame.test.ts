import { describe, expect, it } from 'vitest';
import { Frame, marginIn } from './frame.js';
import type { Zoom } from './frame.js';

const area = { x: 0, y: 0, width: 100, height: 50 };
/** 114 x 64 with its margins: 10 CSS pixels a unit, and room above and below. */
const whole = new Frame(area, { width: 1140, height: 700 });

describe('the whole', () => {
  it('is the area and a margin, in the middle of the box', () => {
    expect(whole.scale).toBe(10);
    expect(whole.at(0, 350)[0]).toBeCloseTo(-7);
    expect(whole.middle).toEqual([50, 25]);
    expect(whole.zoom).toBeNull();
  });

  it('is shown also if a vertex lies farther away than doubles can tell', () => {
    const far = new Frame(area, whole.size, null, [-1e308, 0, Infinity, 50]);
    expect(far.shown.every(Number.isFinite)).toBe(true);
    expect(far.scale).toBe(10);
    expect(far.with(far.all).shown.every(Number.isFinite)).toBe(true);
  });

  it('is unchanged when it is made smaller or moved', () => {
    for (const frame of [whole.zoomed(0.5, [3, 4]), whole.moved(100, -30)]) {
      expect(frame.zoom).toBeNull();
      frame.shown.forEach((value, i) => {
        expect(value).toBeCloseTo(whole.shown[i] ?? NaN);
      });
    }
  });
});

describe('a zoom', () => {
  it('keeps the place under the pointer', () => {
    const at = [300, 400] as const;
    const [x, y] = whole.at(...at);
    const near = whole.zoomed(8, at);
    expect(near.scale).toBe(80);
    expect(near.at(...at)[0]).toBeCloseTo(x);
    expect(near.at(...at)[1]).toBeCloseTo(y);
  });

  it('shows nothing beyond the margin', () => {
    // 11.4 x 7 units at ten times the size; the margin begins at -7.
    const [left, top] = whole.zoomed(10).moved(1e6, 1e6).shown;
    expect(left).toBeCloseTo(-7);
    expect(top).toBeCloseTo(-7);
  });

  it('reaches 64 CSS pixels in any picture, and 40 times the whole', () => {
    const large = new Frame({ ...area, width: 2000, height: 2000 }, { width: 2280, height: 2280 });
    expect(large.scale).toBeCloseTo(1);
    expect(large.zoomed(1e9).scale).toBeCloseTo(64);
    expect(whole.zoomed(1e9).scale).toBeCloseTo(400);
    expect(whole.zoomed(1e9).isLargest).toBe(true);
    expect(whole.zoomed(39).isLargest).toBe(false);
  });

  it('in, and out again around the same point, gives the whole', () => {
    const far = whole.zoomed(20, [10, 10]).zoomed(1 / 20, [1000, 600]);
    expect(far.zoom).toBeNull();
    expect(far.scale).toBe(whole.scale);
  });
});

describe('a square that must be visible', () => {
  const zoom: Zoom = { by: 10, middle: [50, 25] }; // 11.4 x 7 units, from (44.3, 21.5)
  const near = whole.with(zoom);

  it('moves nothing if it is in sight', () => {
    expect(near.showing([50, 25], 1).shown).toEqual(near.shown);
  });

  it('is moved into sight, with its own size as a margin on each side', () => {
    // The pixel 60 and one more end at 62; the pixel 20 and one before it begin at 19.
    const [x, y, width] = near.showing([60, 20], 1).shown;
    expect(x + width).toBeCloseTo(62);
    expect(y).toBeCloseTo(19);
  });
});

describe('a scene that reaches farther than the area', () => {
  // From -8 to 24 and from -6 to 26 about the area from 0 to 16: 32 x 32 units.
  const square = { x: 0, y: 0, width: 16, height: 16 };
  const box = { width: 320, height: 320 };
  const frame = new Frame(square, box, null, [-8, -6, 32, 32]);
  const { all } = frame;

  it('is at first shown as far as the area extends', () => {
    expect(frame.zoom).toBeNull();
    expect(frame.shown).toEqual(new Frame(square, box).shown);
    expect(frame.hasMore).toBe(true);
  });

  it('can be shown as a whole, with the area in the middle', () => {
    const [left, top, width, height] = frame.with(all).shown;
    expect(left).toBeLessThan(-8);
    expect(top).toBeLessThan(-6);
    expect(left + width).toBeGreaterThan(24);
    expect(top + height).toBeGreaterThan(26);
    // 44 CSS pixels around everything are left for the zoom buttons, which lie over the picture.
    const { scale } = frame.with(all);
    expect(
      Math.min(-8 - left, -6 - top, left + width - 24, top + height - 26) * scale,
    ).toBeGreaterThan(43);
    expect(frame.with(all).middle[0]).toBeCloseTo(8);
    expect(frame.with(all).middle[1]).toBeCloseTo(8);
    expect(frame.with(all).isSmallest).toBe(true);
    expect(frame.with(all).zoomed(0.5).scale).toBe(frame.with(all).scale);
  });

  it('stops at the extent of the area on the way in and out', () => {
    expect(frame.with(all).zoomed(10).zoom).toBeNull();
    expect(frame.zoomed(1.5).zoomed(0.1).zoom).toBeNull();
  });

  it('can be moved to its vertices', () => {
    const [x, y] = frame.zoomed(8).moved(1e6, 1e6).shown;
    expect(x).toBeLessThan(-8);
    expect(y).toBeLessThan(-6);
  });

  it('has nothing more to show if it ends within the margin', () => {
    expect(new Frame(square, box, null, [-1, 0, 17, 16]).hasMore).toBe(false);
  });
});

describe('the margin', () => {
  it('is smaller in a small box whose rows need at most two digits', () => {
    const small = { width: 346, height: 600 };
    expect(marginIn(small, { ...area, height: 100 })).toBe(0.05);
    expect(marginIn(small, { ...area, height: 101 })).toBe(0.07);
    expect(marginIn({ width: 500, height: 500 }, area)).toBe(0.07);
  });
});
