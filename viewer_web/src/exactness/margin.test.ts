import { expect, it } from 'vitest';
import { texts } from '../i18n/index.js';
import { labelOf, marginIn, marginMarks, regionOf } from './margin.js';

const flip = { step: 24, at: 'S3', polygon: 'S', edge: 1, point: [0, 0], sign: 1, told: 1 };
const side = (a: string, b: string, c: string, sign: -1 | 0 | 1) => ({
  a,
  b,
  c,
  sign,
  bounds: true,
  flips: [flip],
});
const written = (sides: readonly object[]): string =>
  JSON.stringify({
    format: 'vidno-margin/1',
    step: 25,
    procedure: 'SurroundTest',
    polygon: 'S',
    vertex: 2,
    at: [3, 3],
    sides,
  });
const words = { say: texts.en.exact.margin, point: texts.en.numbers.point };
const area = { x: 0, y: 0, width: 8, height: 8 };

it('cuts the region out of a frame around the area', () => {
  // x > 0, x < 4, y > 1 and y < 2.
  const margin = marginIn(
    written([
      side('1/1', '0/1', '0/1', 1),
      side('1/1', '0/1', '-4/1', -1),
      side('0/1', '1/1', '-1/1', 1),
      side('0/1', '1/1', '-2/1', -1),
    ]),
  );
  const corners = regionOf(margin, area).map((spot) => spot.join(' '));
  expect(new Set(corners)).toEqual(new Set(['0 1', '4 1', '4 2', '0 2']));
  const [shaded, ...notes] = marginMarks(margin, area, words);
  expect(shaded).toMatchObject({ kind: 'path', role: 'margin', closed: true });
  expect(notes).toHaveLength(4);
});

it('describes in words what changes beyond a side', () => {
  const cut = { ...flip, point: undefined, cut: 1, side: 2 };
  const vertex = { ...flip, edge: undefined, point: undefined, vertex: 2, side: 4 };
  const flips = (...all: readonly object[]) => ({ ...side('1/1', '0/1', '0/1', 1), flips: all });
  const { sides } = marginIn(written([flips(flip), flips(cut, vertex)]));
  expect(sides.map((each) => labelOf(each, words))).toEqual([
    'edge 1 over (0, 0)',
    'edge 1 over the top left corner; vertex over the right side',
  ]);
  const russian = { say: texts.ru.exact.margin, point: texts.ru.numbers.point };
  expect(sides.map((each) => labelOf(each, russian))).toEqual([
    'ребро 1 через (0; 0)',
    'ребро 1 через левый верхний угол; вершина через правую сторону',
  ]);
});

it('shows a segment where the vertex must stay on a line', () => {
  // On x = 3, where y > 1 and y < 2.
  const margin = marginIn(
    written([
      side('1/1', '0/1', '-3/1', 0),
      side('0/1', '1/1', '-1/1', 1),
      side('0/1', '1/1', '-2/1', -1),
    ]),
  );
  const ends = regionOf(margin, area).map(([x, y]) => [x, Number(y.toFixed(9))]);
  expect(ends).toHaveLength(2);
  expect(new Set(ends.map(String))).toEqual(new Set(['3,1', '3,2']));
  expect(marginMarks(margin, area, words)[0]).toMatchObject({ role: 'margin', closed: false });
});

it('shows nothing where the vertex must not move', () => {
  const corner = written([side('1/1', '0/1', '-3/1', 0), side('0/1', '1/1', '-3/1', 0)]);
  expect(marginMarks(marginIn(corner), area, words)).toEqual([]);
});
