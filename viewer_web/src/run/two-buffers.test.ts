import { expect, it } from 'vitest';
import { TwoBuffers } from './two-buffers.js';

const bytes = (...values: readonly number[]): Uint8Array<ArrayBuffer> => Uint8Array.from(values);

it('a copy lasts until the copy after the next one, and is then empty', () => {
  const buffers = new TwoBuffers();
  const first = buffers.copy(bytes(1, 2, 3));
  const second = buffers.copy(bytes(4, 5));
  expect([first, second]).toEqual([bytes(1, 2, 3), bytes(4, 5)]);
  const third = buffers.copy(bytes(6));
  expect(first.length).toBe(0);
  expect([second, third]).toEqual([bytes(4, 5), bytes(6)]);
});

it('a copy is not affected by what happens to the original', () => {
  const original = bytes(1, 2);
  const copy = new TwoBuffers().copy(original);
  original.fill(9);
  expect(copy).toEqual(bytes(1, 2));
});

it('more bytes than before get new memory', () => {
  const buffers = new TwoBuffers();
  const copies = [1, 3, 9, 27].map((size) => buffers.copy(new Uint8Array(size).fill(size)));
  expect(copies.map(({ length }) => length)).toEqual([1, 3, 9, 27]);
  expect(copies.every((copy) => copy.every((value) => value === copy.length))).toBe(true);
});
