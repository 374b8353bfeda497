import { filled } from '../../base/filled.js';
import type { ReasonTexts } from '../../language/texts.js';
import words from '../../trace/format-words.json' with { type: 'json' };

export const reasons: ReasonTexts = {
  number: (found) => `здесь должно стоять число, а не ${found}`,
  notNegative: (found) => `здесь должно стоять неотрицательное число, а не ${found}`,
  whole: (found) => `здесь должно стоять целое число, а не ${found}`,
  between: (least, greatest, found) =>
    `здесь должно стоять целое число от ${least} до ${greatest}, а не ${found}`,
  bool: (found) => `здесь должно стоять true или false, а не ${found}`,
  text: (found) => `здесь должен стоять текст, а не ${found}`,
  oneOf: (values, found) => `здесь может стоять ${values}, но не ${found}`,
  newerFormat: (format, found) => filled(words.newer.ru, format, found),
  olderFormat: (format, found) => filled(words.older.ru, format, found),
  list: (found) => `здесь должен стоять список, а не ${found}`,
  object: (found) => `здесь должен стоять объект, а не ${found}`,
  missing: () => 'этого поля нет',
  noSuchPin: (name) => `в уроке нет метки ${name}`,
  noSuchRun: (name) => `в уроке нет прогона ${name}`,
  noWebAddress: (found) => `здесь должен стоять адрес https://…, а не ${found}`,
  emptyFile: () => 'файл пуст',
  emptyList: () => 'список пуст',
  notJson: (found) => `это не JSON: ${found}`,
  notUtf8: () => 'текст не в кодировке UTF-8',
  tooLarge: () => 'файл слишком велик для этой страницы',
};
