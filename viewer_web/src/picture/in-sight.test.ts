import { describe, expect, it } from 'vitest';
import { bringInSight } from './in-sight.js';

const line = (offsetTop: number) => ({ offsetTop, offsetHeight: 20 });

describe('a list', () => {
  it('is scrolled to put a mark that is out of sight at a third of its height', () => {
    const box = { scrollTop: 0, clientHeight: 90 };
    bringInSight(box, line(40));
    expect(box.scrollTop).toBe(0);
    bringInSight(box, line(300));
    expect(box.scrollTop).toBe(270);
  });
});
