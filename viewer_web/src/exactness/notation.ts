import { texts } from '../i18n/index.js';
import type { Language } from '../language/language.js';

/**
 * A calculation in which the operands have the listing's symbols, or words of the language, instead of the trace's names.
 * `other` is the symbol of the depth that z is compared with.
 */
export function inNotation(line: string, language: Language, other = 'z₀'): string {
  const { upper, lower } = texts[language].curves;
  const names = new Map([
    ['against', other],
    ['left', 'x₁'],
    ['right', 'x₂'],
    ['upper', upper],
    ['lower', lower],
  ]);
  return line.replace(/\b[a-z]+\b/gu, (name) => names.get(name) ?? name);
}

/** A number of a trace, whole ones without a denominator. */
export const withoutOne = (text: string): string => text.replace(/\/1$/u, '');
