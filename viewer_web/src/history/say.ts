import { algorithmOf } from '../algorithm/algorithm.js';
import { texts } from '../i18n/index.js';
import type { Language } from '../language/language.js';
import type { Trace } from '../replay/trace.js';
import type { Entry } from './entry.js';
import type { History } from './history.js';
import type { Reason } from './why.js';

const untouched: Reason = { why: 'untouched', polygon: null };

/** An entry in one sentence: that of its step, or for a polygon that missed the pixel only that fact. */
export function sayEntry(entry: Entry, { header, timeline }: Trace, language: Language): string {
  const own = algorithmOf(header).entry?.(entry, texts[language].history) ?? null;
  return own ?? timeline.sentence(entry.step, language);
}

/** Why the pixel has, or after step `now` will have, the colour of this entry, the last one to paint it. */
export function sayWhy(
  entry: Entry,
  history: History,
  language: Language,
  now = entry.step,
): string {
  const { because, whyBackground, why } = texts[language].history;
  const step = entry.step > now ? entry.step.toLocaleString(language) : null;
  const { header } = history.trace;
  const reason = algorithmOf(header).why?.(entry, header) ?? untouched;
  const start = reason.polygon === null ? whyBackground : because;
  return `${start(step)} ${why[reason.why](reason.polygon ?? '')}`;
}
