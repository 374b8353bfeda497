import * as words from '../../language/words.js';
import type { Box, N } from '../../trace/values.js';

/** A number in the Russian format. */
const comma = (text: string): string => text.replace('.', ',');

export const short = (value: N): string => comma(words.short(value));

export const signed = (n: number): string => comma(words.signed(n));

export const whole = (value: N): string => comma(words.whole(value));

export const inFull = (value: N): string => comma(words.inFull(value));

export function shortApart(a: N, b: N): readonly [string, string] {
  const [one, other] = words.shortApart(a, b);
  return [comma(one), comma(other)];
}

/** Semicolons separate numbers, because they contain commas. */
export const joined = (all: readonly string[]): string => all.join('; ');

export const list = (all: readonly N[], write = short): string =>
  joined(all.map((each) => write(each)));

export const point = (at: readonly N[]): string => `(${list(at)})`;

export const windowText = ([x, y, width, height]: Box): string =>
  `${point([x, y])} ${short(width)} × ${short(height)}`;
