import type { Numbers } from '../language/texts.js';
import { agrees, orderOf, relationBy } from '../language/words.js';
import type { Order } from '../language/words.js';
import type { N } from '../trace/values.js';

/** A half-open range of columns, rows or pixels. */
export const half = (range: readonly [first: number, end: number], { list }: Numbers): string =>
  `[${list(range)})`;

/** The comparison of two numbers; the bare relation if the numbers as written have another. */
export const compared = (z: N, other: N, sign: Order, { shortApart }: Numbers): string =>
  orderOf(z, other) === sign
    ? shortApart(z, other).join(` ${relationBy[sign]} `)
    : relationBy[sign];

/** Whether a number is nearer than another one; the bare answer if the numbers as written have another. */
export const nearer = (z: N, against: N, is: boolean, { shortApart }: Numbers): string =>
  agrees(is, z, against) ? shortApart(z, against).join(is ? ' > ' : ' ≯ ') : String(is);

/** The sign of a value. */
export const signOf = (
  { value, sign }: { readonly value: N; readonly sign: Order },
  numbers: Numbers,
): string => `${numbers.short(value)} ${relationBy[sign]} 0`;
