import { describe, expect, it } from 'vitest';
import { Frame } from './frame.js';
import { moved } from './pixel.js';

const area = { x: 2, y: -1, width: 100, height: 50 };

describe('a pixel of the picture', () => {
  it('is found under a point', () => {
    const frame = new Frame(area, { width: 1140, height: 700 });
    expect(frame.scale).toBe(10);
    expect(frame.pixelAt(70.1, 100.1)).toEqual([2, -1]);
    expect(frame.pixelAt(79.9, 109.9)).toEqual([2, -1]);
    expect(frame.pixelAt(80.1, 110.1)).toEqual([3, 0]);
    expect(frame.pixelAt(69, 99)).toEqual([1, -2]);
    expect(frame.place(2)).toEqual({ x: 140, y: 200, scale: 20, ratio: 2 });
  });

  it('is left by the arrow keys, which never leave the picture', () => {
    expect(moved([5, 5], 'ArrowLeft', false, area)).toEqual([4, 5]);
    expect(moved([5, 5], 'ArrowDown', true, area)).toEqual([5, 15]);
    expect(moved([5, 5], 'ArrowUp', true, area)).toEqual([5, -1]);
    expect(moved([101, 5], 'ArrowRight', false, area)).toEqual([101, 5]);
    expect(moved([5, 5], 'Enter', false, area)).toBeNull();
  });
});
