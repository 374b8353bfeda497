import { rangeOf } from '../../language/words.js';
import type { Words } from '../../language/words.js';

const pixels = { one: 'пиксель', few: 'пикселя', other: 'пикселей' };

/** «столбец 3», «столбцы 3–5». */
export const columnsOf = (first: number, last: number): string =>
  `${first === last ? 'столбец' : 'столбцы'} ${rangeOf(first, last)}`;

/** «3 пикселя получают». */
export const takes = (n: number, words: Words): string =>
  `${words.counted(n, pixels)} ${n % 10 === 1 && n % 100 !== 11 ? 'получает' : 'получают'}`;
