import { expect, it } from 'vitest';
import type { Polygon } from './header.js';
import { outlines } from './polygon.js';

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
  expect(outlines([low, high])(high)).toEqual([
    { points: [at(2, 2), at(2, 4)], closed: false },
    { points: [at(2, 4), at(0, 4)], closed: false },
    { points: [at(0, 4), at(0, 2)], closed: false },
  ]);
  expect(outlines([low, high])(low)).toHaveLength(4);
});

it('other polygons have their whole outlines, be they of another face or of none', () => {
  expect(outlines([{ ...low, face: 'M' }, high])(high)).toHaveLength(4);
  const alone = { ...high, face: undefined };
  expect(outlines([low, alone])(alone)).toEqual([{ points: high.vertices, closed: true }]);
});
