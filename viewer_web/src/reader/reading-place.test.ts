import { describe, expect, it } from 'vitest';
import { readingLine, scrolledTo } from './reading-place.js';

describe('the reading line', () => {
  // A text of 4000 px in a box of 900 px can scroll by 3100 px.
  const at = (scrolled: number): number => readingLine(scrolled, 3100, 900);

  it('is at a third of the visible height', () => {
    expect([at(300), at(1500), at(2500)]).toEqual([300, 300, 300]);
  });

  it('starts at the top at the beginning, and moves to the bottom at the end', () => {
    expect([at(0), at(150), at(2800), at(3100)]).toEqual([0, 150, 600, 900]);
  });

  it('passes the whole text if it is hardly longer than the box', () => {
    expect([0, 10, 20, 30].map((scrolled) => readingLine(scrolled, 30, 900))).toEqual([
      0, 300, 600, 900,
    ]);
  });

  it('stays at the beginning if the text cannot scroll', () => {
    expect(readingLine(0, 0, 900)).toBe(0);
  });

  it.each([100, 500, 2000, 3700])('reaches a place %s px from the beginning', (place) => {
    const scrolled = scrolledTo(place, 3100, 900);
    expect(Math.abs(scrolled + at(scrolled) - place)).toBeLessThan(1);
  });
});
