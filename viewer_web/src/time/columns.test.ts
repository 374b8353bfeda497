import { describe, expect, it } from 'vitest';
import { headerOf, linesOf, textOf, textWith, traceOf } from '../testing/traces.js';
import type { Event } from '../trace/events.js';
import { aimedAt, columnsOf, placeOf, stepAt } from './columns.js';
import type { Column } from './columns.js';
import { Course, cases } from './course.js';
import { wholeOf } from './range.js';

async function columnsIn(text: string, count: number): Promise<readonly Column[]> {
  const course = new Course(await traceOf(text));
  course.read();
  return columnsOf(course, count);
}

const partsOf = ({ shares }: Column): readonly unknown[] =>
  shares.map(({ part, steps }) => [cases[part], steps]);

describe('a place on the strip', () => {
  it('is that of a step, from end to end', () => {
    expect([0, 50, 200].map((step) => placeOf(step, wholeOf(200), 100))).toEqual([0, 25, 100]);
    expect(placeOf(0, wholeOf(0), 100)).toBe(0);
  });

  // Steps are at 0, 25, 50, 75 and 100.
  it.each([
    [-3, 0],
    [0, 0],
    [12.4, 0],
    [12.5, 1],
    [37.4, 1],
    [37.6, 2],
    [99, 4],
    [140, 4],
  ])('%d is nearest to step %i of 4', (place, step) => {
    expect(stepAt(place, wholeOf(4), 100)).toBe(step);
  });
});

describe('the columns of a run', () => {
  const windows = textOf('small.warnock.windows.jsonl');

  it('contain every step once, if there are more steps than columns', async () => {
    for (const count of [1, 2, 7, 50, 115]) {
      const columns = await columnsIn(windows, count);
      expect(columns[0]?.first).toBe(0);
      expect(columns.at(-1)?.end).toBe(116); // 115 events and the start
      columns.slice(1).forEach(({ first }, i) => expect(first).toBe(columns[i]?.end));
    }
  });

  it('contain each step several times, if there are fewer', async () => {
    const columns = await columnsIn(windows, 1000);
    const shown = new Set(columns.map(({ first }) => first));
    expect(shown.size).toBe(116);
    expect(columns.filter(({ first }) => first === 60)).toHaveLength(9); // 1000 / 115, rounded
  });

  it('have the share of each case', async () => {
    // 23 columns of five steps each. Windows begin at 2, 8, 14, 20, 23 and 26, see the course.
    const columns = await columnsIn(windows, 23);
    expect(columns[4]).toMatchObject({ first: 20, end: 25 });
    expect(columns.slice(0, 6).map(partsOf)).toEqual([
      [['split', 3]], // nothing is current at steps 0 and 1
      [['split', 5]],
      [['split', 5]],
      [['split', 5]],
      [['pixel', 5]],
      [
        ['pixel', 1],
        ['split', 4],
      ],
    ]);
  });

  it('have the mean and the greatest level', async () => {
    const columns = await columnsIn(windows, 23);
    // Steps 0 to 4: twice no item, three times the area. Steps 5 to 9: three times the area, twice a quarter.
    expect(columns[0]?.levels).toEqual({ mean: 3 / 5, most: 1 });
    expect(columns[1]?.levels).toEqual({ mean: (3 * 1 + 2 * 2) / 5, most: 2 });
    // Steps 25 to 29: a pixel, then four steps of a window 2 x 2.
    expect(columns[5]?.levels).toEqual({ mean: (4 + 4 * 3) / 5, most: 4 });
  });

  it('have the mean and the greatest call depth', async () => {
    const [first, second] = await columnsIn(textOf('inside.warnock.signs.jsonl'), 2);
    // The depths are those of the course: 16 steps, four of them 1 and twelve 2; then 16 steps: 2 twice, 3 three times, 2
    // twice, 1 three times, 2 five times, 1 once.
    expect(first?.calls).toEqual({ mean: (4 + 12 * 2) / 16, most: 2 });
    expect(second?.calls).toEqual({ mean: (4 + 9 + 4 + 3 + 10 + 1) / 16, most: 3 });
  });

  it('lose no wrong decision and no fault among thousands of steps', async () => {
    const many = 5000;
    const step: Event = { e: 'horizontal', at: 'Z9', edge: 0 };
    const events: Event[] = [
      { e: 'polygon', at: 'Z2', polygon: 'A', color: '#112233' },
      ...Array<Event>(many).fill(step),
    ];
    events[1234] = {
      e: 'disagree',
      at: 'Z9',
      of: 'columns',
      taken: [0, 7],
      exact: [0, 8],
      cause: 'rounded',
    };
    events[4321] = { e: 'fault', at: 'L6', reason: 'a write outside the area' };
    const columns = await columnsIn(textWith(headerOf('zbuffer'), events), 10);
    // The event with index i is step i + 1; a column has slightly more than 500 steps.
    const those = (mark: 'wrong' | 'fault' | 'ael'): readonly number[] =>
      columns.flatMap((column, i) => (column[mark] ? [i] : []));
    expect([those('wrong'), those('fault'), those('ael')]).toEqual([[2], [8], []]);
  });

  it('are empty for a run without events', async () => {
    const columns = await columnsIn(linesOf(headerOf('warnock')), 3);
    expect(columns.map(({ first, shares }) => [first, shares])).toEqual([
      [0, []],
      [0, []],
      [0, []],
    ]);
  });
});

describe('pointing', () => {
  const range = wholeOf(10_000); // ten steps per pixel
  const width = 1000;

  it('means the nearest step', () => {
    expect(aimedAt(500, range, width, [[]])).toBe(5000);
  });

  it('means a mark within three pixels, and no farther', () => {
    expect(aimedAt(500, range, width, [[4971, 5031]])).toBe(4971);
    expect(aimedAt(500, range, width, [[4969, 5031]])).toBe(5000);
  });

  it('means marks of the first kind before others that are nearer', () => {
    expect(aimedAt(500, range, width, [[5020], [5010]])).toBe(5020);
    expect(aimedAt(500, range, width, [[9000], [5010]])).toBe(5010);
  });
});
