import { short } from '../../language/words.js';
import type { Phrases } from '../../language/texts.js';

const pixels = { one: 'pixel', other: 'pixels' };

export const columnsOf: Phrases['columnsOf'] = (first, last) =>
  first === last ? `column ${short(first)}` : `columns ${short(first)} to ${short(last)}`;

export const takes: Phrases['takes'] = (n, words) =>
  `${words.counted(n, pixels)} ${n === 1 ? 'takes' : 'take'}`;
