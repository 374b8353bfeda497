import { sentence, texts } from '../i18n/index.js';
import type { Language } from '../language/language.js';
import type { Header } from '../trace/header.js';
import type { Entry } from './entry.js';
import type { History } from './history.js';
import { reasonOf } from './why.js';

/** An entry in one sentence: that of its step, but of a polygon that missed the pixel just this. */
export function sayEntry(entry: Entry, header: Header, language: Language): string {
  const { event, known, outcome } = entry;
  const { history } = texts[language];
  if (outcome === 'fail' && event.e === 'draw') return history.missed(event.polygon);
  if (outcome === 'fail' && event.e === 'span') return history.kept(known.zbuffer?.polygon ?? '');
  return sentence(event, known, known, header, language);
}

/** Why the pixel has the colour that this entry, the last to paint it, gave it. */
export function sayWhy(entry: Entry, history: History, language: Language): string {
  const { because, whyBackground, why } = texts[language].history;
  const reason = reasonOf(entry, history.trace.header);
  const start = reason.polygon === null ? whyBackground : because;
  return `${start} ${why[reason.why](reason.polygon ?? '')}`;
}
