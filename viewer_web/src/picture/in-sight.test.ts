import { describe, expect, it } from 'vitest';
import { Follower } from './in-sight.js';

const size = { width: 200, height: 90 };
const line = (offsetTop: number) => ({ offsetTop, offsetHeight: 20 });
const list = (clientHeight: number) => ({ scrollTop: 0, clientHeight });

describe('a list', () => {
  it('is scrolled to a mark that is out of sight, at a third of its height, and no further', () => {
    const box = list(90);
    new Follower().follow(box, line(40), size);
    expect(box.scrollTop).toBe(0);
    new Follower().follow(box, line(300), size);
    expect(box.scrollTop).toBe(270);
  });

  it('is scrolled again when it has become lower, as in a presentation, with the same mark', () => {
    const box = list(600);
    const mark = line(400);
    const follower = new Follower();
    follower.follow(box, mark, size);
    expect(box.scrollTop).toBe(0);
    box.clientHeight = 150;
    follower.follow(box, mark, { width: 200, height: 150 });
    expect(box.scrollTop).toBe(350);
  });

  it('stays where its reader has scrolled to while neither mark nor size is another', () => {
    const box = list(90);
    const mark = line(300);
    const follower = new Follower();
    follower.follow(box, mark, size);
    box.scrollTop = 0;
    follower.follow(box, mark, size);
    expect(box.scrollTop).toBe(0);
  });
});
