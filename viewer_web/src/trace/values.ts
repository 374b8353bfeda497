import {
  bool,
  either,
  finite,
  list,
  matching,
  oneOf,
  plainNumber,
  plainOf,
  text,
  tuple,
  whole,
  written,
} from './check.js';
import type { Check, Checked } from './check.js';
import { Refusal, describe } from './refusal.js';

/** N of the format: a number of the run's kernel. A reader copies it and never computes with it. */
export type N = number | string;

/** Longer fractions than any run writes would only keep the page busy. */
const word = /^(-?inf|nan|-?\d{1,20000}\/\d{1,20000})$/;
const plainWord = '"(?:-?inf|nan|-?\\d{1,999}/\\d{1,999})"';

export const num = written<N>(`(?:${plainNumber}|${plainWord})`, (value, path) => {
  if (typeof value === 'number' && Number.isFinite(value)) return value;
  if (typeof value === 'string' && word.test(value)) return value;
  throw new Refusal(path, 'kernelNumber', describe(value));
});

/** Whether there are numbers of the kernel in what a check takes. */
export const holdsNumbers = (check: Check<unknown>): boolean => plainOf(check).includes(plainWord);

export const id = text;
export const color = matching(/^#[0-9a-f]{6}$/, 'color');
export const corner = oneOf('lb', 'lt', 'rb', 'rt');
export const pair = tuple(num, num);
/** A column and the height over it, as the scene has them. */
export const sample = tuple(whole, finite);
export const triple = tuple(num, num, num);
export const box = tuple(finite, finite, finite, finite);
export const pixels = tuple(whole, whole, whole, whole);
export const runs = list(tuple(whole, whole, whole));
export const rowRuns = list(tuple(whole, whole));
export const sign = oneOf(-1, 0, 1);

/** What a decision came to: yes or no, a sign or a pixel, or the range first <= i < end. */
export const answer = either(bool, whole, tuple(whole, whole));
const nothing = written<null>('null', (value, path) => {
  if (value === null) return null;
  throw new Refusal(path, 'answer', describe(value));
});
/** The right answer; null where it is undefined. */
export const truth = either(nothing, answer);

export type Answer = Checked<typeof answer>;
export type Color = Checked<typeof color>;
export type Corner = Checked<typeof corner>;
export type Pair = Checked<typeof pair>;
export type Sample = Checked<typeof sample>;
export type Triple = Checked<typeof triple>;
export type Box = Checked<typeof box>;

/** The text's four corners, in the order in which their depths are computed. */
export const corners = ['lb', 'lt', 'rb', 'rt'] as const satisfies readonly Corner[];
