import { describe, expect, it } from 'vitest';
import { ErrorAxis, costDomain } from './axes.js';
import { boxOf, flags, placeNames, wrapped } from './labels.js';
import type { Box, Name } from './labels.js';
import { logTicks } from './ticks.js';

describe('ticks', () => {
  it.each([
    [[0.95, 2.1], 600, [1, 1.2, 1.4, 1.6, 1.8, 2]],
    [[0.9, 110], 400, [1, 2, 5, 10, 20, 50, 100]],
    [[0.9, 110], 200, [1, 3, 10, 30, 100]],
    [[1, 1e6], 400, [1, 10, 100, 1e3, 1e4, 1e5, 1e6]],
    [[1, 1e6], 160, [1, 100, 1e4, 1e6]],
  ] as const)('from %j on %i pixels', (domain, length, ticks) => {
    expect(logTicks(domain, length, 40)).toEqual(ticks);
  });

  it('are finite for any range of the axis', () => {
    expect(logTicks([1e-300, 1e300], 600, 40).length).toBeLessThan(15);
    expect(logTicks([1e-300, 1e300], 1, 40)).toHaveLength(0);
  });
});

describe('the axis of costs', () => {
  it.each([[[]], [[3]], [[1, 1e308]], [[5e-324, 1]], [[1, 2, 200]]])('%j has two ends', (costs) => {
    const [least, greatest] = costDomain(costs);
    expect(least).toBeGreaterThan(0);
    expect(greatest).toBeGreaterThan(least);
    expect(greatest).toBeLessThan(Infinity);
  });
});

describe('the axis of errors', () => {
  const room = { below: 50, word: 20, tick: 20 };
  const axis = new ErrorAxis([0, 0.002, 0, 0.3, Infinity], 0, room, 400);

  it('rises from one line for zero through the divide and the decades to infinity', () => {
    const places = [
      axis.at(0),
      axis.divide,
      axis.at(0.001),
      axis.at(0.01),
      axis.at(1),
      axis.at(Infinity),
      axis.height,
    ];
    expect(places).toEqual([...places].sort((x, y) => x - y));
    expect(axis.at(0)).toBe(50);
    expect(axis.at(0.1) - axis.at(0.01)).toBeCloseTo(axis.at(1) - axis.at(0.1));
  });

  it('has ticks for both lines, too', () => {
    const values = axis.ticks().map(({ value }) => value);
    expect([values[0], values.at(-1)]).toEqual([0, Infinity]);
    expect(values).toContain(0.01);
  });

  it('has the error of the right picture on the line of the right points', () => {
    const ofArea = new ErrorAxis([0.12, 0.5], 0.12, room, 400);
    expect(ofArea.at(0.12)).toBe(50);
    expect(ofArea.at(0.5)).toBeGreaterThan(ofArea.divide);
    expect(ofArea.ticks()[0]).toEqual({ at: 50, value: 0.12 });
  });

  it.each([[[]], [[0]], [[5e-324]], [[1e308, 5e-324]], [[Infinity]], [[1]]])(
    'has a place for %j',
    (errors) => {
      const found = new ErrorAxis(errors, 0, room, 300);
      for (const at of [...errors.map((error) => found.at(error)), found.ticks()[0]?.at]) {
        expect(at).toBeGreaterThan(0);
        expect(at).toBeLessThan(300);
      }
    },
  );
});

const overlaps = (a: Box, b: Box): boolean =>
  a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

function named(text: string, x: number, y: number): Name {
  return { x, y, lines: [{ text, bold: false }] };
}

describe('names', () => {
  const bounds = { width: 300, top: 0, bottom: 200, font: 10, radius: 4 };

  it('are beside their points, and move aside', () => {
    const names = [named('first', 100, 50), named('second', 100, 55)];
    const { texts } = placeNames(names, names, [], bounds);
    const [first, second] = texts.map((text) => boxOf(text, bounds.font));
    expect(texts.map(({ text }) => text)).toEqual(['first', 'second']);
    expect(first && second && overlaps(first, second)).toBe(false);
  });

  it('stay inside', () => {
    const names = [named('edge', 299, 50)];
    const { texts } = placeNames(names, names, [], bounds);
    expect(texts.map((text) => boxOf(text, bounds.font).right <= 300)).toEqual([true]);
  });

  it('are left out where there is no room', () => {
    const name = named('a text that is far too long for this', 40, 50);
    expect(placeNames([name], [], [], { ...bounds, width: 80 }).texts).toEqual([]);
  });

  it('of points on one line hang below each other where they would meet', () => {
    const names = [0, 10, 20, 200].map((x) => named('Z-buffer', x, 0));
    const { texts, stems, height } = flags(names, bounds);
    const boxes = texts.map((text) => boxOf(text, bounds.font));
    for (const [i, box] of boxes.entries()) {
      expect(boxes.slice(0, i).some((other) => overlaps(box, other))).toBe(false);
      // No stem crosses a name.
      const crossed = stems.filter(({ x, to }) => x > box.left && x < box.right && to > box.top);
      expect(crossed).toEqual([]);
      expect(box.bottom).toBeLessThanOrEqual(height);
    }
  });

  it('break into lines at their spaces', () => {
    expect(wrapped('aaa bbb ccc', 5)).toEqual(['aaa bbb', 'ccc']);
    expect(wrapped('aaaaaaaaaa b', 2)).toEqual(['aaaaaaaaaa', 'b']);
  });
});
