import { expect, it } from 'vitest';
import { outlineLines } from './faces.js';
import type { Polygon } from './header.js';

const at = (x: number, y: number): Polygon['vertices'][number] => [x, y, 0];
const low: Polygon = {
  id: 'L.1',
  color: '#000000',
  face: 'L',
  vertices: [at(0, 0), at(4, 0), at(4, 2), at(2, 2), at(0, 2)],
};
const high: Polygon = {
  id: 'L.2',
  color: '#000000',
  face: 'L',
  vertices: [at(0, 2), at(2, 2), at(2, 4), at(0, 4)],
};

it('the parts of a face have no line where they meet', () => {
  expect(outlineLines(high, [low, high])).toEqual([
    { points: [at(2, 2), at(2, 4)], closed: false },
    { points: [at(2, 4), at(0, 4)], closed: false },
    { points: [at(0, 4), at(0, 2)], closed: false },
  ]);
  expect(outlineLines(low, [low, high])).toHaveLength(4);
});

it('other polygons have their whole outlines, be they of another face or of none', () => {
  const whole = [{ points: high.vertices, closed: true }];
  expect(outlineLines(high, [{ ...low, face: 'M' }, high])).toEqual(whole);
  const { face: _, ...alone } = high;
  expect(outlineLines(alone, [low, alone])).toEqual(whole);
});
