import type { ChartTexts } from '../language/texts.js';
import type { Language } from '../language/language.js';
import type { ReasonTexts } from '../language/texts.js';
import type { Refusal } from '../trace/refusal.js';
import { chart as en } from './en/chart.js';
import { reasons as enReasons } from './en/reasons.js';
import { chart as ru } from './ru/chart.js';
import { reasons as ruReasons } from './ru/reasons.js';

export const chartTexts: Readonly<Record<Language, ChartTexts>> = { en, ru };

const reasons: Readonly<Record<Language, ReasonTexts>> = { en: enReasons, ru: ruReasons };

/** An error in a file: place and reason. */
export function chartComplaint(
  name: string,
  { path, reason, details }: Refusal,
  language: Language,
): string {
  const say: (...details: string[]) => string = reasons[language][reason];
  return chartTexts[language].unreadable(name, path, say(...details));
}
