import type { Event } from '../trace/events.js';
import type { Unreadable } from '../trace/trace.js';
import * as en from './en/index.js';
import type { Language } from './language.js';
import * as ru from './ru/index.js';
import type { Texts } from './texts.js';
import { Words, counted } from './words.js';
import type { Known, PluralForms, ShownHeader } from './words.js';

export const texts: Readonly<Record<Language, Texts>> = { en: en.texts, ru: ru.texts };

const rules: Readonly<Record<Language, Intl.PluralRules>> = {
  en: new Intl.PluralRules('en'),
  ru: new Intl.PluralRules('ru'),
};

/** "3 pixels", "3 пикселя". */
export const countedIn = (language: Language, n: number, forms: PluralForms): string =>
  counted(n, forms, rules[language]);

/** What a step did, in one sentence. */
export function sentence(
  event: Event,
  before: Known,
  after: Known,
  header: ShownHeader,
  language: Language,
): string {
  const words = new Words(before, after, header, texts[language], rules[language]);
  const say = texts[language].sentences[event.e] as (event: Event, words: Words) => string;
  return say(event, words);
}

/** What is wrong with a file: line, place and reason. */
export function complaint(name: string, { line, refusal }: Unreadable, language: Language): string {
  const { reasons, page } = texts[language];
  const say: (...details: string[]) => string = reasons[refusal.reason];
  return page.unreadable(name, line, refusal.path, say(...refusal.details));
}
