import { describe, expect, it } from 'vitest';
import { textOf, traceNames, traceOf } from '../testing/traces.js';
import { numberOf } from '../trace/events.js';
import type { FloatingHorizonEvents, Event } from '../trace/events.js';
import { Lines } from './lines.js';

type Drawn = FloatingHorizonEvents['draw_line'];
type Columns = Drawn['fromColumns'];

const on = (x: number): Columns => [x, x];
const curve = (place: number): Event => ({ e: 'curve', at: 'FH2', curve: place });

/** A line over the segment from column 0 to column 4, at height 1, between two places. */
const drawn = (from: number, to: number, segment: Drawn['segment'] = [0, 4]): Drawn => {
  const columns = (x: number): Columns => [Math.floor(x), Math.ceil(x)];
  return {
    e: 'draw_line',
    at: 'FH6',
    segment,
    from: [from, 1],
    fromColumns: columns(from),
    to: [to, 1],
    toColumns: columns(to),
  };
};

/** The curve, start and end of each line after the events. */
function linesOf(...events: readonly Event[]): readonly unknown[] {
  const names = Uint8Array.from(events, ({ e }) => numberOf.get(e) ?? 0);
  const lines = new Lines({ names, event: (step) => events[step - 1] ?? null });
  return lines.at(events.length).map(({ curve: of, from, to }) => [of, from[0], to[0]]);
}

describe('the lines that are drawn', () => {
  it('continue if one ends on the column where the next one of the same segment begins', () => {
    expect(linesOf(curve(0), drawn(0, 1), drawn(1, 2.5))).toEqual([[0, 0, 2.5]]);
  });

  it('are separate if they meet between columns', () => {
    expect(linesOf(curve(0), drawn(0, 1.5), drawn(1.5, 3))).toEqual([
      [0, 0, 1.5],
      [0, 1.5, 3],
    ]);
  });

  it('are separate in another segment, and on another curve', () => {
    const next: Drawn['segment'] = [4, 8];
    expect(linesOf(curve(0), drawn(3, 4), drawn(4, 5, next), curve(1), drawn(5, 6))).toEqual([
      [0, 3, 4],
      [0, 4, 5],
      [1, 5, 6],
    ]);
  });

  it('replace a point at their start, and absorb one at their end', () => {
    const point = { ...drawn(2, 2), fromColumns: on(2), toColumns: on(2) };
    expect(linesOf(curve(0), point)).toEqual([[0, 2, 2]]);
    expect(linesOf(curve(0), point, drawn(2, 3))).toEqual([[0, 2, 3]]);
    expect(linesOf(curve(0), drawn(1, 2), point, drawn(2, 3, [2, 6]))).toEqual([
      [0, 1, 2],
      [0, 2, 3],
    ]);
  });

  it.each(traceNames.filter((name) => name.startsWith('hills.')))(
    'are the same whether a step of %s is come to from before or from after',
    async (name) => {
      const { timeline } = await traceOf(textOf(name));
      const all = new Lines(timeline);
      const last = all.at(timeline.length);
      expect(last.length).toBeGreaterThan(10);
      for (let step = timeline.length; step >= 0; step--) {
        expect(all.at(step)).toEqual(new Lines(timeline).at(step));
      }
    },
  );
});
