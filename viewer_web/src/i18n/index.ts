import type { Language } from '../language/language.js';
import { inWords } from '../language/library-reason.js';
import type { Texts } from '../language/texts.js';
import { counted } from '../language/words.js';
import type { PluralForms } from '../language/words.js';
import type { Complaint } from '../replay/trace.js';
import * as en from './en/index.js';
import * as ru from './ru/index.js';

export const texts: Readonly<Record<Language, Texts>> = { en: en.texts, ru: ru.texts };

export const rulesOf: Readonly<Record<Language, Intl.PluralRules>> = {
  en: new Intl.PluralRules('en'),
  ru: new Intl.PluralRules('ru'),
};

/** "3 pixels", "3 пикселя". */
export const countedIn = (language: Language, n: number, forms: PluralForms): string =>
  counted(n, forms, rulesOf[language]);

/** An error in a file: line, place and reason. */
export function complaint(
  name: string,
  { line, path, reason }: Complaint,
  language: Language,
): string {
  const { page, scene } = texts[language];
  if (reason === 'empty, not a trace') return page.emptyFile(name);
  return page.unreadable(name, line, path, inWords(reason, scene));
}

/** A notice of the line up to which the file is a valid trace. */
export function wrongLine({ line, path, reason }: Complaint, language: Language): string {
  const { page, scene } = texts[language];
  return page.wrongLine(line, path, inWords(reason, scene));
}
