import { expect, it } from 'vitest';
import { cornerAct } from './corner-keys.js';
import { addPolygon, emptySketch } from '../run/sketch.js';
import type { Sketch } from '../run/sketch.js';

const drawn = addPolygon(emptySketch, [
  [0, 0, 0],
  [4, 0, 0.5],
  [0, 4, 1],
]);

/** The second corner after several keys, all pressed before the page has shown any of them. */
function after(...keys: readonly Partial<KeyboardEvent>[]): readonly number[] | undefined {
  const acts = keys.map((key) => cornerAct(key as KeyboardEvent, { polygon: 0, vertex: 1 }));
  const edited = acts.reduce<Sketch>(
    (old, act) => (act?.do === 'edit' ? act.edit(old) : old),
    drawn,
  );
  return edited.polygons[0]?.vertices[1];
}

it('successive keys add up', () => {
  const right = { key: 'ArrowRight', shiftKey: false, altKey: false };
  expect(after(right, right)).toEqual([4.5, 0, 0.5]); // a quarter of a pixel each
  expect(after(right, { ...right, shiftKey: true })).toEqual([5.25, 0, 0.5]);
  expect(after({ key: 'PageUp' }, { key: 'PageUp' })).toEqual([4, 0, 0.625]); // 1/16 each
});

it('a depth ends at 1, and other keys have no effect', () => {
  const up = Array.from({ length: 20 }, () => ({ key: 'PageUp' }));
  expect(after(...up)).toEqual([4, 0, 1]);
  expect(after({ key: 'q' })).toEqual([4, 0, 0.5]);
});
