export const languages = ['en', 'ru'] as const;
export type Language = (typeof languages)[number];

/** A text, or any other value, in each language. */
export type Bilingual<T> = Readonly<Record<Language, T>>;

/** The value that `make` gives for each language. */
export const inEachLanguage = <T>(make: (language: Language) => T): Bilingual<T> =>
  Object.fromEntries(languages.map((language) => [language, make(language)])) as Bilingual<T>;

/** Each language by its own name. */
export const languageNames: Bilingual<string> = {
  en: 'English',
  ru: 'Русский',
};

export function isLanguage(value: unknown): value is Language {
  return languages.includes(value as Language);
}

/** The reader's own language, if the page speaks it. */
export function preferredLanguage(): Language {
  return languages.find((each) => navigator.language.startsWith(each)) ?? 'en';
}
