import { short } from '../../language/words.js';
import type { Words } from '../../language/words.js';

const pixels = { one: 'pixel', other: 'pixels' };

/** "column 3", "columns 3 to 5". */
export const columnsOf = (first: number, last: number): string =>
  first === last ? `column ${short(first)}` : `columns ${short(first)} to ${short(last)}`;

/** "3 pixels take". */
export const takes = (n: number, words: Words): string =>
  `${words.counted(n, pixels)} ${n === 1 ? 'takes' : 'take'}`;
