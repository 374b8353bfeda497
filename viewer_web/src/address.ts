import { isLanguage } from './i18n/language.js';
import type { Language } from './i18n/language.js';

/** What the page's address holds behind `#`: language, embedded trace and step. */
export interface Address {
  readonly language: Language | null;
  readonly trace: string | null;
  readonly step: number;
}

export function parseAddress(hash: string): Address {
  const fields = new URLSearchParams(hash.replace(/^#/, ''));
  const language = fields.get('lang');
  const step = Number(fields.get('step'));
  return {
    language: isLanguage(language) ? language : null,
    trace: fields.get('trace'),
    step: Number.isSafeInteger(step) && step > 0 ? step : 0,
  };
}

export function formatAddress({ language, trace, step }: Address): string {
  const fields = new URLSearchParams();
  if (language !== null) fields.set('lang', language);
  if (trace !== null) {
    fields.set('trace', trace);
    fields.set('step', String(step));
  }
  return `#${fields.toString()}`;
}
