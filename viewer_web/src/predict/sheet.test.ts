import { describe, expect, it } from 'vitest';
import type { Part, Question } from './question.js';
import { optionsOf } from './asker.js';
import {
  answerOf,
  emptySheet,
  filledIn,
  firstWrong,
  hintCost,
  hinted,
  pointsOf,
  pressed,
} from './sheet.js';
import type { Entry } from './sheet.js';

const sees: Part = { asks: 'wins', options: optionsOf(['A', 'B', 'C']), right: ['B'] };
const shown: Part = { asks: 'shown', options: optionsOf(['3', '4', '5', '6']), right: ['4', '5'] };
const list: Part = {
  asks: 'list',
  options: optionsOf(['1', '2', '3', 'x']),
  right: ['x', 'x', '2', '3'],
};
const table: Part = { asks: 'entries', options: [], right: ['7.75', '3', '6.25', '5'] };
const asked: Question = {
  kind: 'point',
  step: 1,
  until: 2,
  about: { point: [0, 0] },
  parts: [sees, shown, list],
  because: [2],
  things: [],
};
const blank: Entry = { chosen: [], hints: 0, ruledOut: [] };

const after = (part: Part, ...values: readonly string[]): Entry =>
  values.reduce((entry, value) => pressed(part, entry, value), blank);

describe('an option that is chosen', () => {
  it('replaces the one before', () => {
    expect(after(sees, 'A', 'C').chosen).toEqual(['C']);
  });

  it('is turned on and off among several', () => {
    expect(after(shown, '3', '5', '3').chosen).toEqual(['5']);
  });

  it('continues a row, which may repeat a crossing and takes back a vertex', () => {
    expect(after(list, 'x', 'x', '2').chosen).toEqual(['x x 2']);
    expect(after(list, 'x', '2', '2').chosen).toEqual(['x']);
    expect(after(list, '2', '2').chosen).toEqual([]);
  });

  it('is part of the answer', () => {
    const sheet = [after(sees, 'B'), after(shown, '4'), after(list, 'x', '3')];
    expect(answerOf(asked, sheet)).toEqual([['B'], ['4'], ['x', '3']]);
    expect(answerOf(asked, emptySheet(asked))).toEqual([null, [], null]);
  });
});

describe('a cell of a table', () => {
  const filled = (...cells: readonly string[]): Entry =>
    cells.reduce((entry, text, cell) => filledIn(table, entry, cell, text), blank);

  it('is filled in alone', () => {
    expect(filledIn(table, blank, 2, '6.25').chosen).toEqual(['', '', '6.25', '']);
    expect(filledIn(table, filled('1', '2'), 1, '3').chosen).toEqual(['1', '3', '', '']);
  });

  it('holds a number when the table is an answer', () => {
    const answerWith = (...cells: readonly string[]) =>
      answerOf({ ...asked, parts: [table] }, [filled(...cells)])[0];
    expect(answerWith('7,75', '3', '25/4', '5')).toEqual(['7,75', '3', '25/4', '5']);
    expect(answerWith('7.75', '3', '6.25')).toBeNull();
    expect(answerWith('7.75', '3', 'left', '5')).toBeNull();
  });

  it('is put right by a hint, for a quarter of the point of four cells', () => {
    const first = hinted(table, filled('7.75', '4'));
    expect(first).toMatchObject({ chosen: ['7.75', '3', '', ''], hinted: '1', hints: 1 });
    expect(hinted(table, first)).toMatchObject({ chosen: ['7.75', '3', '6.25', ''], hinted: '2' });
    expect(hinted(table, filled('7.75', '3', '6.25', '5')).hinted).toBeNull();
    expect(hintCost(table)).toBe(1 / 4);
  });
});

describe('the first wrong entry', () => {
  it.each([
    [shown, ['4', '5'], null],
    [shown, ['5', '6'], { value: '4', at: 1 }],
    [list, ['x', 'x', '2', '3'], null],
    [list, ['x', '2', '3'], { value: 'x', at: 1 }],
    [list, ['x', 'x', '2', '3', '1'], { value: null, at: 4 }],
    [sees, ['A'], { value: 'B', at: 0 }],
    [table, ['31/4', '3', '6.25', '5'], null],
    [table, ['7.75', '3', '6.5', '4'], { value: '6.25', at: 2 }],
  ])('of %o for %o is %o', (part, given, wrong) => {
    expect(firstWrong(part, given)).toEqual(wrong);
  });
});

describe('a hint', () => {
  it('rules out one wrong option, and takes it back if it was chosen', () => {
    const once = hinted(sees, after(sees, 'A'));
    expect(once).toEqual({ chosen: [], hints: 1, ruledOut: ['A'], hinted: 'A' });
    expect(hinted(sees, once).ruledOut).toEqual(['A', 'C']);
    expect(hinted(sees, hinted(sees, once)).hinted).toBeNull();
  });

  it('corrects the first wrong one of several options', () => {
    expect(hinted(shown, after(shown, '3', '4'))).toMatchObject({ chosen: ['4'], hinted: '3' });
    expect(hinted(shown, after(shown, '4', '5'))).toMatchObject({ hinted: null, hints: 1 });
  });

  it('continues a row up to the first entry that was wrong', () => {
    expect(hinted(list, after(list, 'x', '3'))).toMatchObject({ chosen: ['x x'], hinted: 'x' });
    expect(hinted(list, blank)).toMatchObject({ chosen: ['x'], hinted: 'x' });
    expect(hinted(list, { ...blank, chosen: ['x x 2 3 1'] }).chosen).toEqual(['x x 2 3']);
    expect(hinted({ ...list, right: [] }, blank).chosen).toEqual(['-']);
  });

  it('costs the share of what it gives away', () => {
    expect([sees, shown, list].map(hintCost)).toEqual([1 / 2, 1 / 4, 1 / 4]);
    const sheet = [
      { ...blank, hints: 1 },
      { ...blank, hints: 1 },
      { ...blank, hints: 9 },
    ];
    // 1 - 1/2, 1 - 1/4, and not less than 0.
    expect(pointsOf(asked, [true, true, true], sheet)).toBe(1.25);
    expect(pointsOf(asked, [false, true, true], sheet)).toBe(0.75);
  });
});
