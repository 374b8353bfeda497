import { crossing, parts as forms } from './question.js';
import type { Part, Question } from './question.js';

/** The values that were chosen or typed for each part; null for a part without an answer. */
export type Answer = readonly (readonly string[] | null)[];

const same = (a: readonly string[], b: readonly string[]): boolean =>
  a.length === b.length && a.every((value, i) => value === b[i]);

/** The number in a typed text: a decimal, with a point or a comma, or a fraction; null if it is none. */
export function typedNumber(text: string): number | null {
  const plain = text.trim().replace(/[−–]/g, '-').replace(',', '.');
  const [, above = '', below = '1'] = /^(-?\d+(?:\.\d+)?)(?:\/(\d+))?$/u.exec(plain) ?? [];
  const value = Number(above) / Number(below);
  return above === '' || !Number.isFinite(value) ? null : value;
}

/** How far from the right number a cell may be: by rounding to three decimals. */
export const tolerance = 0.0005;

/** Whether the number in a cell is right, as far as three decimals show. */
export function isRightNumber(given: string, right: string): boolean {
  const roundoff = 1e-9;
  return Math.abs((typedNumber(given) ?? NaN) - Number(right)) <= tolerance + roundoff;
}

/** Whether a part is answered correctly; the order matters in a row and in a table. */
export function isRight({ asks, right }: Part, given: readonly string[]): boolean {
  const [form] = forms[asks];
  if (form === 'table') return right.every((value, i) => isRightNumber(given[i] ?? '', value));
  if (form !== 'some') return same(given, right);
  return same([...given].sort(), [...right].sort());
}

/** Which parts are answered correctly. */
export function grade({ parts }: Question, answer: Answer): readonly boolean[] {
  return parts.map((part, i) => {
    const given = answer[i] ?? null;
    return given !== null && isRight(part, given);
  });
}

/** How well a question was answered: all parts, some or none; or not at all, which is not wrong. */
export function howWell(
  given: Answer | null,
  right: readonly boolean[],
): 'right' | 'some' | 'wrong' | 'givenUp' {
  if (given === null) return 'givenUp';
  if (right.every(Boolean)) return 'right';
  return right.some(Boolean) ? 'some' : 'wrong';
}

/** The text for an empty row. */
export const emptyRow = '-';

/** The row of options in a typed text, with any separators; null if the text is not a row. */
export function typedRow({ asks, options }: Part, text: string): readonly string[] | null {
  const plain = text
    .trim()
    .replace(/[−–]/g, '-')
    .replace(/[xх×*]/giu, crossing);
  if (plain === '') return null;
  if (plain === emptyRow && forms[asks][1] !== 'sign') return [];
  const row = plain.match(/\d+|[^\s,;]/g) ?? [];
  return row.every((each) => options.some(({ value }) => value === each)) ? row : null;
}
