import { describe, expect, it } from 'vitest';
import { texts } from '../i18n/index.js';
import { headerOf, textOf, textWith, traceOf } from '../testing/traces.js';
import type { Event } from '../trace/events.js';
import { Course } from './course.js';
import { ownStep, sayPlace } from './place.js';

async function readCourse(text: string): Promise<Course> {
  const course = new Course(await traceOf(text));
  course.read();
  return course;
}

describe('the place of a step', () => {
  it('is a window and its case', async () => {
    const course = await readCourse(textOf('small.warnock.windows.jsonl'));
    const say = (step: number): string => sayPlace(course, step, [], texts.en);
    expect(say(0)).toBe('Step 0 of 115');
    expect(say(1)).toBe('Step 1 of 115');
    expect(say(2)).toBe('Step 2 of 115: window 8 × 8 at (2, −1), split');
    expect(say(22)).toBe('Step 22 of 115: window 1 × 1 at (6, 2), pixel');
    expect(sayPlace(course, 22, [], texts.ru)).toBe('Шаг 22 из 115: окно 1 × 1 в (6; 2), пиксель');
  });

  it('is a polygon and a row', async () => {
    const course = await readCourse(textOf('small.zbuffer.windows.jsonl'));
    const say = (step: number): string => sayPlace(course, step, [], texts.en);
    expect(say(11)).toBe('Step 11 of 19: polygon B');
    expect(say(12)).toBe('Step 12 of 19: polygon B, row −1');
    expect(say(15)).toBe('Step 15 of 19: polygon B, row 0');
  });

  it('includes the marks there', async () => {
    const events: readonly Event[] = [
      { e: 'polygon', at: 'Z2', polygon: 'A', color: '#112233' },
      { e: 'disagree', at: 'Z2', of: 'rows', taken: [0, 7], exact: [0, 8], cause: 'rounded' },
      { e: 'fault', at: 'S2', reason: 'the list of edges ends' },
    ];
    const course = await readCourse(textWith(headerOf('zbuffer'), events));
    const bookmarks = [
      { step: 1, note: '' },
      { step: 2, note: 'see?' },
    ];
    const say = (step: number): string => sayPlace(course, step, bookmarks, texts.en);
    expect(say(1)).toBe('Step 1 of 3: polygon A, bookmark');
    expect(say(2)).toBe('Step 2 of 3: polygon A, wrong decision, bookmark “see?”');
    expect(say(3)).toBe('Step 3 of 3: polygon A, the printed text fails');
  });
});

const clear: Event = { e: 'clear', at: 'Z1', color: '#ffffff', z: '-inf' };
const polygon: Event = { e: 'polygon', at: 'Z2', polygon: 'A', color: '#112233' };
const wrong: Event = {
  e: 'disagree',
  at: 'Z2',
  of: 'rows',
  taken: [0, 1],
  exact: [0, 2],
  cause: 'rounded',
};

it.each([
  [0, 0],
  [1, 1], // clear
  [2, 3], // polygon, in the checked run after a verdict
  [3, 5], // polygon
])('step %i of a run is step %i of the same one, checked', async (step, checked) => {
  const header = headerOf('zbuffer');
  const plain = await traceOf(textWith(header, [clear, polygon, polygon]));
  const checkedRun = await traceOf(textWith(header, [clear, wrong, polygon, wrong, polygon]));
  expect(ownStep(plain.timeline, step, checkedRun.timeline)).toBe(checked);
  expect(ownStep(checkedRun.timeline, checked, plain.timeline)).toBe(step);
  expect(ownStep(checkedRun.timeline, 5, (await traceOf(textWith(header, [clear]))).timeline)).toBe(
    1,
  );
});
