import { describe, expect, it } from 'vitest';
import { bringInSight, bringLineInSight } from './in-sight.js';

const line = (offsetTop: number) => ({ offsetTop, offsetHeight: 20 });

describe('a list', () => {
  it('is scrolled to put a mark that is out of sight at a third of its height', () => {
    const box = { scrollTop: 0, clientHeight: 90 };
    bringInSight(box, line(40));
    expect(box.scrollTop).toBe(0);
    bringInSight(box, line(300));
    expect(box.scrollTop).toBe(270);
  });

  it('shows a line and its neighbours, from the first line if there is room', () => {
    const box = { scrollTop: 500, clientHeight: 90 };
    const lines = [100, 120, 140, 160, 180, 200, 220].map(line);
    bringLineInSight(box, lines, 2);
    expect(box.scrollTop).toBe(100);
    // The last line is in sight, but the one after it is not: then two thirds of the list end with that one.
    bringLineInSight(box, lines, 4);
    expect(box.scrollTop).toBe(160);
    bringLineInSight(box, lines, 3);
    expect(box.scrollTop).toBe(140);
    // Nothing follows the last line; text fades over the last 30.
    bringLineInSight(box, lines, 6, 30);
    expect(box.scrollTop).toBe(200);
    // The line and its neighbours take 60 of 90, so they need a part of those 35 where text fades.
    bringLineInSight(box, lines, 4, 35);
    expect(box.scrollTop).toBe(160);
  });
});
