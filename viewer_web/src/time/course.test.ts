import { describe, expect, it } from 'vitest';
import { headerOf, textOf, textWith, traceOf } from '../testing/traces.js';
import type { Event } from '../trace/events.js';
import { Course, cases } from './course.js';

async function readCourse(text: string): Promise<Course> {
  const course = new Course(await traceOf(text));
  course.read();
  return course;
}

const courseIn = (name: string): Promise<Course> => readCourse(textOf(`${name}.jsonl`));

const windows = ({ stretches: { first, level, part } }: Course): readonly unknown[] =>
  first.map((step, i) => [step, level[i], cases[part[i] ?? -1] ?? null]);

describe('the course of a run', () => {
  it('has the windows, the case of each, and the number of divisions that led to it', async () => {
    // By hand from the file: the area 8 x 8, then in its right half 4 x 4, 2 x 2 and two pixels.
    const course = await courseIn('small.warnock.windows');
    expect(windows(course).slice(0, 6)).toEqual([
      [2, 1, 'split'],
      [8, 2, 'split'],
      [14, 3, 'split'],
      [20, 4, 'pixel'],
      [23, 4, 'pixel'],
      [26, 3, 'split'],
    ]);
    expect(course.finest).toBe(4);
    expect(course.deepest).toBe(1);
  });

  it('has an undecided window where the run breaks off', async () => {
    const [header = '', ...lines] = textOf('small.warnock.windows.jsonl').split('\n');
    const course = await readCourse([header, ...lines.slice(0, 8), ''].join('\n'));
    expect(windows(course)).toEqual([
      [2, 1, 'split'],
      [8, 2, null],
    ]);
  });

  it('has the polygons of the Z-buffer algorithm in their order', async () => {
    const course = await courseIn('small.zbuffer.windows');
    expect(course.stretches).toEqual({ first: [2, 11], level: [1, 1], part: [0, 1] });
  });

  it('finds the stretch of a step', async () => {
    const course = await courseIn('small.zbuffer.windows');
    expect([0, 1, 2, 10, 11, 19].map((step) => course.indexAt(step))).toEqual([-1, -1, 0, 0, 1, 1]);
  });

  it('has the depth of the calls after each step', async () => {
    // ProcessWindow takes steps 4 to 23, and in it SurroundTest 18 to 21; FillPolygon takes 26 to 31.
    const { depths, deepest } = await courseIn('inside.warnock.signs');
    const run = (depth: number, times: number): number[] => Array<number>(times).fill(depth);
    expect([...depths]).toEqual([
      ...run(1, 4), // steps 0 to 3
      ...run(2, 14),
      ...run(3, 3), // 18 to 20
      ...run(2, 2),
      ...run(1, 3), // 23 to 25
      ...run(2, 5),
      1,
    ]);
    expect(deepest).toBe(3);
  });

  it('has every change of AEL, wrong decision and fault', async () => {
    expect((await courseIn('small.zbuffer.signs')).ael).toEqual([15, 16, 73, 74, 82, 85]);
    const wrong = {
      e: 'disagree',
      at: 'Z2',
      of: 'rows',
      taken: [0, 7],
      exact: [0, 8],
      cause: 'rounded',
    } as const;
    const events: readonly Event[] = [
      { e: 'polygon', at: 'Z2', polygon: 'B', color: '#445566' },
      wrong,
      { e: 'fault', at: 'L6', reason: 'a write outside the area', x: 16, y: 3 },
      wrong,
    ];
    const course = await readCourse(textWith(headerOf('zbuffer'), events));
    expect([course.wrong, course.faults]).toEqual([[2, 4], [3]]);
  });

  it('is the same when it is read in parts', async () => {
    const trace = await traceOf(textOf('small.warnock.signs.jsonl'));
    const inParts = new Course(trace);
    const many = Array<number>(40_000).fill(0);
    expect(inParts.complete).toBe(false);
    while (!inParts.read(0)) many.pop();
    const atOnce = new Course(trace);
    atOnce.read();
    expect(inParts.stretches).toEqual(atOnce.stretches);
    expect(inParts.depths).toEqual(atOnce.depths);
  });
});
