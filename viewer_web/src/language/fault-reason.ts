import type { Language } from './language.js';

/** The reasons that a run can give for its fault, in Russian. A trace has them in English. */
const russian: Readonly<Record<string, string>> = {
  'an outline does not close': 'контур не замыкается',
  'division by zero': 'деление на нуль',
  'more lists than the lines can divide the area into':
    'списков больше, чем частей, на которые прямые могут разделить область',
  'more scanlines than any area has rows': 'строк развёртки больше, чем строк в любой области',
  'more steps than any area has columns': 'шагов больше, чем столбцов в любой области',
  'outside the area': 'выход за пределы области',
  'the last entry of AEL has no partner': 'последняя запись AEL осталась без пары',
  'the list of vertices is read past its end': 'чтение за концом списка вершин',
};

/** The reason in the language. Reasons that another program has written remain as they are. */
export const faultReason = (language: Language, reason: string): string =>
  (language === 'ru' ? russian[reason] : undefined) ?? reason;
