import type { Numbers } from '../language/texts.js';
import { agrees, orderOf } from '../language/words.js';
import type { N } from '../trace/values.js';

/** A half-open range of columns, rows or pixels. */
export const half = (range: readonly [first: number, end: number], { list }: Numbers): string =>
  `[${list(range)})`;

const order: Readonly<Record<string, string>> = { '-1': '<', '0': '=', '1': '>' };

/** The comparison of two numbers; the bare relation if the numbers as written have another. */
export const compared = (z: N, other: N, sign: number, { shortApart }: Numbers): string =>
  orderOf(z, other) === sign
    ? shortApart(z, other).join(` ${order[sign] ?? ''} `)
    : (order[sign] ?? '');

/** Whether a number is nearer than another one; the bare answer if the numbers as written have another. */
export const nearer = (z: N, against: N, is: boolean, { shortApart }: Numbers): string =>
  agrees(is, z, against) ? shortApart(z, against).join(is ? ' > ' : ' ≯ ') : String(is);

/** The sign of a value. */
export const signOf = (
  { value, sign }: { readonly value: N; readonly sign: number },
  numbers: Numbers,
): string => `${numbers.short(value)} ${order[sign] ?? ''} 0`;
