import { filled } from '../../base/filled.js';
import type { ReasonTexts } from '../../language/texts.js';
import words from '../../trace/format-words.json' with { type: 'json' };

export const reasons: ReasonTexts = {
  number: (found) => `a number is expected here, not ${found}`,
  notNegative: (found) => `a number that is not negative is expected here, not ${found}`,
  whole: (found) => `a whole number is expected here, not ${found}`,
  between: (least, greatest, found) =>
    `a whole number from ${least} to ${greatest} is expected here, not ${found}`,
  bool: (found) => `true or false is expected here, not ${found}`,
  text: (found) => `text is expected here, not ${found}`,
  oneOf: (values, found) => `${values} is expected here, not ${found}`,
  newerFormat: (format, found) => filled(words.newer.en, format, found),
  olderFormat: (format, found) => filled(words.older.en, format, found),
  list: (found) => `a list is expected here, not ${found}`,
  object: (found) => `an object is expected here, not ${found}`,
  missing: () => 'this field is missing',
  noSuchPin: (name) => `the lesson has no pin ${name}`,
  noSuchRun: (name) => `the lesson has no run ${name}`,
  noWebAddress: (found) => `an address such as https://… is expected here, not ${found}`,
  emptyFile: () => 'the file is empty',
  emptyList: () => 'the list is empty',
  notJson: (found) => `this is not JSON: ${found}`,
  notUtf8: () => 'the text is not UTF-8',
  tooLarge: () => 'the file is too large for this page',
};
