import { rangeOf } from '../../language/words.js';
import type { Phrases } from '../../language/texts.js';

const pixels = { one: 'пиксель', few: 'пикселя', other: 'пикселей' };

export const columnsOf: Phrases['columnsOf'] = (first, last) =>
  `${first === last ? 'столбец' : 'столбцы'} ${rangeOf(first, last)}`;

export const takes: Phrases['takes'] = (n, words) =>
  `${words.counted(n, pixels)} ${n % 10 === 1 && n % 100 !== 11 ? 'получает' : 'получают'}`;
