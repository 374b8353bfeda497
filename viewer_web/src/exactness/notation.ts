import { texts } from '../i18n/index.js';
import type { Language } from '../language/language.js';

/**
 * A calculation in which the operands have the listing's symbols, or words of the language, instead of the trace's names.
 * `other` is the symbol of the depth that z is compared with.
 */
export function inNotation(line: string, language: Language, other = 'z₀'): string {
  const { upper, lower } = texts[language].curves;
  const names: Readonly<Record<string, string>> = {
    against: other,
    left: 'x₁',
    right: 'x₂',
    upper,
    lower,
  };
  return line.replace(/\b(?:against|left|right|upper|lower)\b/gu, (name) => names[name] ?? name);
}

/** A number of a trace, whole ones without a denominator. */
export const withoutOne = (text: string): string => text.replace(/\/1$/u, '');
