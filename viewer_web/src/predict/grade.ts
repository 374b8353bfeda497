import { crossing, parts as forms } from './question.js';
import type { Part, Question } from './question.js';

/** The values that were chosen for each part, or typed; null where there is no answer yet. */
export type Answer = readonly (readonly string[] | null)[];

const same = (a: readonly string[], b: readonly string[]): boolean =>
  a.length === b.length && a.every((value, i) => value === b[i]);

/** Whether a part is answered right; only in a row the order matters. */
export function isRight({ asks, right }: Part, given: readonly string[]): boolean {
  if (forms[asks][0] !== 'some') return same(given, right);
  return same([...given].sort(), [...right].sort());
}

/** Which parts are answered right. */
export function grade({ parts }: Question, answer: Answer): readonly boolean[] {
  return parts.map((part, i) => {
    const given = answer[i] ?? null;
    return given !== null && isRight(part, given);
  });
}

/** How an empty row is typed. */
export const emptyRow = '-';

/** The row of options that was typed, with or without anything between them; null if it is none. */
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
