import { texts } from '../i18n/index.js';
import type { Language } from '../language/language.js';

/**
 * Numbers or a calculation with the operands of a trace, in the notation of the panel: the listing's symbols, and words of
 * the language. `other` is the symbol of the depth that z is compared with.
 */
export function inNotation(text: string, language: Language, other = 'z₀'): string {
  const { upper, lower } = texts[language].curves;
  const names: Readonly<Record<string, string>> = {
    against: other,
    left: 'x₁',
    right: 'x₂',
    upper,
    lower,
  };
  return text.replace(/\b(?:against|left|right|upper|lower)\b/gu, (name) => names[name] ?? name);
}

/** A number of a trace, whole ones without a denominator. */
export const withoutOne = (text: string): string => text.replace(/\/1$/u, '');
