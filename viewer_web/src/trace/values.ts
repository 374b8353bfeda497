import {
  bool,
  either,
  finite,
  list,
  matching,
  plainNumber,
  plainOf,
  text,
  tuple,
  whole,
  written,
} from './check.js';
import type { Check, Checked } from './check.js';
import type { corners } from './event-table.js';
import { Refusal, describe } from './refusal.js';

/** The values that FORMAT.md names, under the same names; the table of events builds the others from them. */

export { between, bool, count, list, oneOf, optional, text, tuple, whole } from './check.js';

/** N of the format: a number of the run's kernel. A reader copies it and never computes with it. */
export type N = number | string;

/** Longer fractions, which no run writes, would only keep the page busy. */
const word = /^(-?inf|nan|-?\d{1,20000}\/\d{1,20000})$/;
const plainWord = '"(?:-?inf|nan|-?\\d{1,999}/\\d{1,999})"';

export const number = written<N>(`(?:${plainNumber}|${plainWord})`, (value, path) => {
  if (typeof value === 'number' && Number.isFinite(value)) return value;
  if (typeof value === 'string' && word.test(value)) return value;
  throw new Refusal(path, 'kernelNumber', describe(value));
});

/** Whether the values of a check contain numbers of the kernel. */
export const holdsNumbers = (check: Check<unknown>): boolean => plainOf(check).includes(plainWord);

export const polygon = text;
export const color = matching(/^#[0-9a-f]{6}$/, 'color');
export const point = tuple(number, number);
export const vertex = tuple(number, number, number);
export const window = tuple(finite, finite, finite, finite);
export const rect = tuple(whole, whole, whole, whole);
export const runs = list(tuple(whole, whole, whole));
export const rowRuns = list(tuple(whole, whole));
/** Loops with the region always on the same side, so that holes have the opposite direction. */
export const region = list(list(point));
/** A part of a polygon, and whether it is known to be behind all others of its list. */
export const piece = tuple(polygon, region, bool);
/** A column and the height over it, as in the scene. */
export const sample = tuple(whole, finite);
export const heights = list(tuple(whole, number));

/** The result of a decision: yes or no, a sign, a pixel, or the range first <= i < end. */
export const answer = either(bool, whole, tuple(whole, whole));
const nothing = written<null>('null', (value, path) => {
  if (value === null) return null;
  throw new Refusal(path, 'answer', describe(value));
});
/** The right answer; null if it is undefined. */
export const truth = either(nothing, answer);

/** A value of a decision under any kernel: a fraction, or a non-finite machine number. */
export const fraction = written<string>(plainWord, (value, path) => {
  if (typeof value === 'string' && word.test(value)) return value;
  throw new Refusal(path, 'kernelNumber', describe(value));
});
/** The operands of a decision: the names, the numbers of the run, and the right numbers, which may be undefined. */
export const operands = list(tuple(text, fraction, either(nothing, fraction)));

/** The label of any line of the procedures with these letters. */
export const label = (letters: readonly string[]): Check<string> =>
  matching(new RegExp(`^(?:${letters.join('|')})[1-9]\\d?$`), 'label');

export type Answer = Checked<typeof answer>;
export type Operands = Checked<typeof operands>;
export type Color = Checked<typeof color>;
export type Corner = (typeof corners)[number];
export type Point = Checked<typeof point>;
export type Vertex = Checked<typeof vertex>;
export type Sample = Checked<typeof sample>;
export type Region = Checked<typeof region>;
export type Piece = Checked<typeof piece>;
export type Box = Checked<typeof window>;
