import { expect, it } from 'vitest';
import { Undo } from './undo.js';

it('undoes changes and redoes them', () => {
  const undo = new Undo('a');
  undo.change('b');
  undo.change('c');
  undo.undo();
  expect(undo.value).toBe('b');
  undo.undo();
  expect([undo.value, undo.canUndo]).toEqual(['a', false]);
  undo.redo();
  undo.redo();
  expect([undo.value, undo.canRedo]).toEqual(['c', false]);
});

it('undoes successive changes with the same name together, until they are settled', () => {
  const undo = new Undo(0);
  undo.change(1, 'drag');
  undo.change(2, 'drag');
  undo.settle();
  undo.change(3, 'drag');
  undo.undo();
  expect(undo.value).toBe(2);
  undo.undo();
  expect(undo.value).toBe(0);
});

it('forgets undone changes when another change is made', () => {
  const undo = new Undo(0);
  undo.change(1);
  undo.undo();
  undo.change(2);
  expect(undo.canRedo).toBe(false);
});

it('does not count a change to the same value', () => {
  const undo = new Undo(0);
  undo.change(0);
  expect(undo.canUndo).toBe(false);
});
