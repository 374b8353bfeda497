import { expect, it } from 'vitest';
import { refusalOf } from './refusal.js';
import { addPolygon, emptySketch } from './sketch.js';

const drawn = addPolygon(emptySketch, [
  [0, 0, 0],
  [1, 0, 0],
  [0, 1, 0],
]);

it.each([
  ['scene: /polygons/0/vertices: not convex', 'A', 'not convex'],
  ['scene: /polygons/0/vertices/1/2: z outside -1 to 1\n', 'A', 'z outside -1 to 1'],
  ['scene: /window/width: not from 1 to 16384', '/window/width', 'not from 1 to 16384'],
  ['scene: line 2, column 3: not valid JSON', null, 'line 2, column 3: not valid JSON'],
  ['scene: /polygons/7: twice', '/polygons/7', 'twice'],
])('%s', (message, polygon, reason) => {
  expect(refusalOf(message, drawn)).toEqual({ polygon, reason });
});
