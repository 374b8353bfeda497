import { describe, expect, it } from 'vitest';
import { orderOf } from '../language/words.js';
import { saying } from '../testing/saying.js';
import { methodOf } from '../testing/method-of-event.js';
import { headerOf } from '../testing/traces.js';
import type { Edition } from '../trace/editions.js';
import type { Detail, Event } from '../trace/events.js';

const window = [0, 0, 4, 2] as const;
const apl = [['A', false]] as const;
const inWindow: readonly Event[] = [
  { e: 'push', at: 'W3', window, apl },
  { e: 'pop', at: 'W5', window },
];
const clipping: Event = { e: 'clip_begin', at: 'PL1', polygon: 'A', window };

/** What is said of the last event of a run of this edition, in each language. Fractions are numbers of the kernel `exact`. */
function said(
  events: readonly Event[],
  edition: Edition,
  detail: Detail = 'signs',
): readonly string[] {
  const last = events.at(-1);
  if (last === undefined) throw new Error('nothing is said of no event');
  const kernel = JSON.stringify(events).includes('/') ? 'exact' : 'double';
  return saying({ ...headerOf(methodOf(last), detail), edition, kernel }, ...events);
}

const pixel = (z: number, stored: number, shown: boolean): Event => ({
  e: 'pixel',
  at: 'L6',
  x: 3,
  y: 1,
  z,
  stored,
  shown,
});

describe('a sentence claims no more than the step', () => {
  it('about a pixel: the printed text shows ties, and nothing beyond 1', () => {
    expect(said([pixel(0.5, 0.5, true)], 'printed')).toEqual([
      'Pixel (3, 1): 0.5 is as near as 0.5, so it shows.',
      'Пиксель (3; 1): 0,5 так же близко, как 0,5, и многоугольник виден.',
    ]);
    expect(said([pixel(1.5, -1, false)], 'printed')[0]).toBe(
      'Pixel (3, 1): 1.5 is nearer than −1 but greater than 1, so it stays hidden.',
    );
    expect(said([pixel(0.5, 0.25, true)], 'printed')[0]).toMatch(/0\.5 is nearer than 0\.25, so/u);
  });

  it('about depths that look otherwise: the step may compare more than it writes, or be wrong', () => {
    expect(said([pixel(0.25, 0.5, true)], 'corrected')).toEqual([
      'Pixel (3, 1): 0.25 counts as nearer than 0.5, so it shows.',
      'Пиксель (3; 1): 0,25 считается ближе, чем 0,5, и многоугольник виден.',
    ]);
    expect(said([pixel(0.5, 0.25, false)], 'corrected')[0]).toMatch(/counts as not nearer than/u);
    const compare: Event = {
      ...{ e: 'compare', at: 'PW6', polygon: 'A', corner: 'lb' },
      ...{ z: 0.5, against: 0.5, nearer: true },
    };
    expect(said([compare], 'corrected')).toEqual([
      'At the top left A counts as nearer: 0.5 against 0.5.',
      'В левом верхнем углу A считается ближе: 0,5 против 0,5.',
    ]);
    expect(said([{ ...compare, z: 0.75 }], 'corrected')[0]).toMatch(/A is nearer: 0\.75 > 0\.5/u);
    const order: Event = {
      ...{ e: 'order', at: 'PR2', polygon: 'A', other: 'B', point: [1, 1] },
      ...{ z: '1/3', otherZ: '1/3', order: -1 },
    };
    expect(said([order], 'corrected')[0]).toMatch(/A counts as behind B: 1\/3 against 1\/3\./u);
  });

  it('about a line: one that covers no centre may still lie in the area', () => {
    const miss = (at: Event<'miss'>['at']): string =>
      said([{ e: 'miss', at }], 'corrected')[0] ?? '';
    expect(miss('L1')).toMatch(/^The row lies outside the area/u);
    expect(miss('L2')).toMatch(/^No pixel of the area lies between the ends/u);
  });

  it('about a side: its name follows its position, in any order of the sides', () => {
    const side = (
      from: Event<'clip_side'>['from'],
      to: Event<'clip_side'>['to'],
    ): string | undefined =>
      said(
        [...inWindow, clipping, { e: 'clip_side', at: 'PL2', side: 2, from, to }],
        'clip-order-reversed',
      )[0];
    expect(side([4, 0], [4, 2])).toBe(
      'Side 2 of 4, the right one, from (4, 0) to (4, 2): the new list is empty.',
    );
    expect(side(['0/1', '0/1'], ['0/1', '2/1'])).toMatch(/the left one/u);
    expect(side([4, 0], [0, 0])).toMatch(/the top one/u);
    expect(side([0, 2], [4, 2])).toMatch(/the bottom one/u);
  });

  it('about a ray: a method that counts each vertex twice does not say which vertices it meets', () => {
    const ray: Event = { e: 'ray', at: 'CR3', polygon: 'A', edge: 1, counts: 2 };
    expect(said([ray], 'corrected')[0]).toMatch(/touches it, which counts as two/u);
    expect(said([ray], 'vertex-counted-twice')[0]).toMatch(/touching or piercing/u);
  });

  it('about a box: one that touches the window’s side is inside, but not strictly', () => {
    const insider: Event = { e: 'insider', at: 'PW10', polygon: 'A', inside: false };
    expect(said([insider], 'corrected')).toEqual([
      'The box of A, the first that is counted, does not lie strictly inside the window.',
      'Габаритный прямоугольник A, первого из учтённых, не лежит строго внутри окна.',
    ]);
  });

  it('about a flag: the printed text may not draw what it finds below (X-H1)', () => {
    const below: Event = { e: 'visibility', at: 'FH5', segment: [0, 4], x: 3, flag: -1 };
    const looking: readonly Event[] = [
      { e: 'curve', at: 'FH2', curve: 0 },
      { e: 'call', at: 'FH5', of: 'Visibility' },
    ];
    expect(said([...looking, below], 'corrected')).toEqual([
      'Over column 3 the curve is visible (−1): it is on the lower horizon or below it.',
      'Над столбцом 3 кривая видна (−1): она на нижнем горизонте или ниже него.',
    ]);
    expect(said([...looking, below], 'printed')).toEqual([
      'Over column 3 the curve is on the lower horizon or below it (−1).',
      'Над столбцом 3 кривая — на нижнем горизонте или ниже него (−1).',
    ]);
    expect(said([...looking, { ...below, flag: 1 }], 'printed')[0]).toMatch(/ visible \(1\): /u);
  });

  it('about a list: the level of windows does not say which polygons have left it', () => {
    expect(said(inWindow, 'corrected', 'windows')).toEqual([
      'The window (0, 0) 4 × 2 comes off the stack.',
      'Окно (0; 0) 4 × 2 берётся из стека.',
    ]);
  });
});

it.each([
  [0.5, 0.25, 1],
  [0.5, 0.5, 0],
  ['-inf', -3, -1],
  ['-inf', '-inf', 0],
  ['nan', 0, null],
  ['1/3', '333333333333333333333/1000000000000000000000', 1],
  ['-1/2', '-2/4', 0],
  ['1/2', 'inf', -1],
] as const)('orders %s and %s: %s', (a, b, order) => {
  expect(orderOf(a, b)).toBe(order);
});
