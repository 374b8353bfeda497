import { describe, expect, it } from 'vitest';
import { ErrorAxis, costDomain } from './axes.js';
import { joined, placeLabels } from './labels.js';
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
  const axis = new ErrorAxis(
    [
      { error: 0, series: 'a' },
      { error: 0.002, series: 'a' },
      { error: 0, series: 'c' },
      { error: 0.3, series: 'b' },
      { error: Infinity, series: 'b' },
    ],
    ['a', 'b', 'c'],
    10,
    400,
  );

  it('rises from zero through the decades to infinity', () => {
    const places = [
      axis.at(0, 'c'),
      axis.at(0, 'a'),
      axis.zeroBand,
      axis.at(0.001),
      axis.at(0.01),
      axis.at(1),
      axis.infiniteBand,
      axis.at(Infinity, 'b'),
      axis.height,
    ];
    expect(places).toEqual([...places].sort((x, y) => x - y));
    expect(axis.at(0.1) - axis.at(0.01)).toBeCloseTo(axis.at(1) - axis.at(0.1));
  });

  it('has ticks for the bands too', () => {
    const values = axis.ticks().map(({ value }) => value);
    expect([values[0], values.at(-1)]).toEqual([0, Infinity]);
    expect(values).toContain(0.01);
  });

  it.each([[[]], [[0]], [[5e-324]], [[1e308, 5e-324]], [[Infinity]], [[1]]])(
    'has a place for %j',
    (errors) => {
      const points = errors.map((error) => ({ error, series: 'a' }));
      const found = new ErrorAxis(points, ['a'], 10, 300);
      for (const at of [...errors.map((error) => found.at(error, 'a')), found.ticks()[0]?.at]) {
        expect(at).toBeGreaterThan(0);
        expect(at).toBeLessThan(300);
      }
    },
  );
});

describe('labels', () => {
  const bounds = { width: 200, height: 100, font: 10, radius: 4 };

  it('are beside their points, and move aside', () => {
    const labels = [
      { text: 'first', x: 100, y: 50 },
      { text: 'second', x: 100, y: 55 },
    ];
    const [first, second] = placeLabels(labels, labels, bounds);
    expect(first?.x).toBeGreaterThan(100);
    expect(second?.x).toBeLessThan(100);
  });

  it('stay inside', () => {
    const [label] = placeLabels([{ text: 'edge', x: 199, y: 50 }], [], bounds);
    expect(label?.x).toBeLessThan(190);
  });

  it('are left out where there is no room', () => {
    const label = { text: 'a text that is far too long for this', x: 100, y: 50 };
    expect(placeLabels([label], [], { ...bounds, width: 80 })).toEqual([]);
  });

  it('of one point are joined, with each text once', () => {
    const at = (text: string): { text: string; x: number; y: number } => ({ text, x: 1, y: 2 });
    expect(
      joined([at('a'), at('b'), at('a'), { ...at('c'), x: 9 }]).map(({ text }) => text),
    ).toEqual(['a, b', 'c']);
  });
});
