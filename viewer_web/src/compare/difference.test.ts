import { describe, expect, it } from 'vitest';
import { headerOf, textOf, textWith, traceOf } from '../testing/traces.js';
import { Comparison } from './comparison.js';
import { differenceAt, differingColumns } from './difference.js';
import type { Line } from '../replay/values.js';

/** A line of a curve over some columns. */
const line = (curve: number, first: number, last: number): Line => ({
  curve,
  from: [first, 1],
  to: [last, 1],
  columns: [first, last],
});

describe('two runs of curves', () => {
  it('differ by the columns over which only one of them has a line of a curve', () => {
    expect(differingColumns([line(0, 0, 4)], [line(0, 0, 2)])).toBe(2);
    expect(differingColumns([line(0, 0, 1), line(0, 1, 2)], [line(0, 0, 2)])).toBe(0);
    expect(differingColumns([line(0, 0, 2)], [line(1, 0, 2)])).toBe(6);
  });

  it('differ by a gap between two columns over which both have a line', () => {
    const points = [line(0, 0, 0), line(0, 1, 1)];
    expect(differingColumns([line(0, 0, 1)], points)).toBe(1);
    expect(differingColumns([line(0, 0, 2)], [line(0, 0, 1), line(0, 2, 2)])).toBe(1);
  });

  it('do not differ if one draws in two pieces what the other draws in one', () => {
    const halves: readonly Line[] = [
      { curve: 0, from: [0, 1], to: ['1/3', 1], columns: [0, 0] },
      { curve: 0, from: ['1/3', 1], to: [1, 1], columns: [1, 1] },
    ];
    expect(differingColumns([line(0, 0, 1)], halves)).toBe(0);
  });

  it('cannot be compared with a run of polygons', async () => {
    const curves = await traceOf(textOf('crossing.floating-horizon.signs.jsonl'));
    const polygons = await traceOf(textWith(headerOf('warnock'), []));
    expect(differenceAt(curves, 0, polygons, 0)).toBeNull();
  });

  it('have a counter of drawn lines, and are paired by column', async () => {
    const text = textOf('crossing.floating-horizon.signs.jsonl');
    const [one, other] = [await traceOf(text), await traceOf(text)];
    const comparison = new Comparison(one, other);
    comparison.read();
    // The first line is one line. The second is split where it crosses the first.
    expect(comparison.counts()[0]).toMatchObject({ curves: 2, lines: 3, flags: 10, crossings: 2 });
    expect(comparison.differsAtEnd).toBe(0);
    expect(comparison.paired(20)).toBe(20);
  });
});
