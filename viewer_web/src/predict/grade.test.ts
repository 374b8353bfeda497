import { describe, expect, it } from 'vitest';
import { questionFrom } from '../testing/questions.js';
import { textOf, traceOf } from '../testing/traces.js';
import { grade, howWell, isRight, typedNumber, typedRow } from './grade.js';
import type { Part } from './question.js';

const window = async (): Promise<ReturnType<typeof questionFrom<'window'>>> =>
  questionFrom(await traceOf(textOf('small.warnock.signs.jsonl')), 1, 'window');

const row = (asks: 'signs' | 'order' | 'list', values: string, right: string): Part => ({
  asks,
  options: values.split('').map((value) => ({ value })),
  right: right.split(''),
});

describe('an answer', () => {
  it('is right only if each part is', async () => {
    const question = await window();
    expect(grade(question, [['A', 'B'], [''], ['split']])).toEqual([true, true, true]);
    expect(grade(question, [['B', 'A'], [''], ['split']])).toEqual([true, true, true]);
    expect(grade(question, [['A'], [''], ['split']])).toEqual([false, true, true]);
    expect(grade(question, [['A', 'B'], ['A'], ['surrounded']])).toEqual([true, false, false]);
    expect(grade(question, [['A', 'B'], [''], null])).toEqual([true, true, false]);
  });

  it('that is a row is right only in the right order', async () => {
    const trace = await traceOf(textOf('small.zbuffer.signs.jsonl'));
    const question = questionFrom(trace, 72, 'ael');
    const entries = ['3', '2', '5.6', '2'];
    const graded = (order: readonly string[]) => grade(question, [['0'], ['1'], order, entries]);
    expect(graded(['2', '1'])).toEqual([true, true, true, true]);
    expect(graded(['1', '2'])).toEqual([true, true, false, true]);
  });
});

describe('a table of numbers', () => {
  // 10/3 and 7, each in its cell.
  const table: Part = { asks: 'entries', options: [], right: [String(10 / 3), '7'] };

  it('is right if each cell is, to three decimals', () => {
    expect(isRight(table, ['3.333', '7'])).toBe(true);
    expect(isRight(table, ['10/3', '7,00'])).toBe(true);
    expect(isRight(table, ['3.33', '7'])).toBe(false);
    expect(isRight(table, ['3.334', '7'])).toBe(false);
    expect(isRight(table, ['7', '3.333'])).toBe(false);
    expect(isRight(table, ['3.333'])).toBe(false);
  });

  it.each([
    ['7.75', 7.75],
    ['−7,75', -7.75],
    [' 31/4 ', 7.75],
    ['', null],
    ['7.', null],
    ['1/0', null],
    ['1e3', null],
    ['x', null],
  ])('reads %o as %o', (text, value) => {
    expect(typedNumber(text)).toBe(value);
  });
});

describe('a typed row', () => {
  it('may have any separators or none', () => {
    const order = row('order', '0123', '31');
    expect(['3 1', ' 3, 1 ', '3;1'].map((text) => typedRow(order, text))).toEqual(
      Array.from({ length: 3 }, () => ['3', '1']),
    );
    expect(typedRow(row('signs', '+0-', '+0-'), '+0−')).toEqual(['+', '0', '-']);
    expect(typedRow(row('list', '12x', 'x1'), 'Х 1')).toEqual(['x', '1']);
  });

  it('may be empty, if that is typed explicitly', () => {
    const order = row('order', '01', '');
    expect([typedRow(order, '−'), typedRow(order, '-')]).toEqual([[], []]);
    expect(typedRow(order, '  ')).toBeNull();
    expect(typedRow(row('signs', '+0-', '-'), '-')).toEqual(['-']);
  });

  it('contains only available values', () => {
    expect(typedRow(row('order', '01', '0'), '31')).toBeNull();
    expect(typedRow(row('list', '12x', 'x1'), '1 y')).toBeNull();
  });
});

describe('the outcome of an answer', () => {
  it('is right, partly right, wrong, or none, which is not wrong', () => {
    expect(howWell([['a'], ['b']], [true, true])).toBe('right');
    expect(howWell([['a'], ['b']], [true, false])).toBe('some');
    expect(howWell([['a'], ['b']], [false, false])).toBe('wrong');
    expect(howWell(null, [false, false])).toBe('givenUp');
  });
});
