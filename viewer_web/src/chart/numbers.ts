import { languages } from '../language/language.js';
import type { Language } from '../language/language.js';
import { superscript } from '../language/words.js';

const longest = 1e5;
const shortest = 1e-3;
const space = '\u00a0';

function formats(options: Intl.NumberFormatOptions): Readonly<Record<Language, Intl.NumberFormat>> {
  const of = languages.map((each) => [each, new Intl.NumberFormat(each, options)] as const);
  return Object.fromEntries(of) as Readonly<Record<Language, Intl.NumberFormat>>;
}

const rounded = formats({ maximumSignificantDigits: 3 });
const wholes = formats({ maximumFractionDigits: 0 });
const times: Readonly<Record<Language, string>> = { en: '×', ru: '·' };

/** Three digits, with a power of ten if there would be many zeros. */
export function number(value: number, language: Language): string {
  if (value === Infinity) return '∞';
  if (value === 0 || (value >= shortest && value < longest)) return rounded[language].format(value);
  const [digits = '', exponent = ''] = value.toExponential(2).split('e');
  const before = Number(digits);
  const scale = `10${superscript(Number(exponent))}`;
  return before === 1 ? scale : `${rounded[language].format(before)}${times[language]}${scale}`;
}

/** A count, with all its digits. */
export function whole(value: number, language: Language): string {
  return wholes[language].format(value);
}

export function ratio(value: number, language: Language): string {
  return `×${number(value, language)}`;
}

export function percent(share: number, language: Language): string {
  return `${number(share * 100, language)}${language === 'en' ? '' : space}%`;
}

type Unit = 's' | 'ms' | 'µs';

const units: Readonly<Record<Language, Readonly<Record<Unit, string>>>> = {
  en: { s: 's', ms: 'ms', µs: 'µs' },
  ru: { s: 'с', ms: 'мс', µs: 'мкс' },
};

export function duration(seconds: number, language: Language): string {
  const [unit, scale]: readonly [Unit, number] =
    seconds >= 1 ? ['s', 1] : seconds >= 1e-3 ? ['ms', 1e3] : ['µs', 1e6];
  return `${number(seconds * scale, language)}${space}${units[language][unit]}`;
}
