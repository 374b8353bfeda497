import type { Language } from '../language/language.js';
import type { Texts } from '../language/texts.js';
import { counted } from '../language/words.js';
import type { PluralForms } from '../language/words.js';
import type { Complaint } from '../replay/read.js';
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

function reasonOf({ refusal }: Complaint, language: Language): string {
  const say: (...details: string[]) => string = texts[language].reasons[refusal.reason];
  return say(...refusal.details);
}

/** An error in a file: line, place and reason. */
export function complaint(name: string, wrong: Complaint, language: Language): string {
  const { page } = texts[language];
  const { line, refusal } = wrong;
  if (refusal.reason === 'emptyFile') return page.emptyFile(name);
  return page.unreadable(name, line, refusal.path, reasonOf(wrong, language));
}

/** The same for the line up to which the file is a valid trace. */
export function wrongLine(wrong: Complaint, language: Language): string {
  const { line, refusal } = wrong;
  return texts[language].page.wrongLine(line, refusal.path, reasonOf(wrong, language));
}
