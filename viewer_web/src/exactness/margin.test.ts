import { expect, it } from 'vitest';
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
const area = { x: 0, y: 0, width: 8, height: 8 };

it('cuts the region out of a frame about the area', () => {
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
  const [shaded, ...notes] = marginMarks(margin, area);
  expect(shaded).toMatchObject({ kind: 'path', role: 'margin', closed: true });
  expect(notes).toHaveLength(4);
});

it('says in a few letters what changes beyond a side', () => {
  const [first] = marginIn(written([side('1/1', '0/1', '0/1', 1)])).sides;
  expect(first && labelOf(first)).toBe('1 (0, 0)');
  const cut = { ...flip, point: undefined, cut: 1, side: 2 };
  const vertex = { ...flip, edge: undefined, point: undefined, vertex: 2, side: 4 };
  const [clip] = marginIn(
    written([{ ...side('1/1', '0/1', '0/1', 1), flips: [cut, vertex] }]),
  ).sides;
  expect(clip && labelOf(clip)).toBe('1/1 | 2; v2 | 4');
});

it('shades nothing where the vertex must stay on a line', () => {
  expect(marginMarks(marginIn(written([side('1/1', '0/1', '-3/1', 0)])), area)).toEqual([]);
});
