import { rulesOf, texts } from '../i18n/index.js';
import type { Bilingual, Language } from '../language/language.js';
import { Words, withoutDoubledSigns } from '../language/words.js';
import type { Known, ShownHeader } from '../language/words.js';
import type { CommonEvents, Event } from '../trace/events.js';
import { algorithmOf } from './algorithm.js';
import { commonSentences } from './common-sentences.js';

type Say = (event: Event, words: Words) => string;

/** One sentence that describes a step. */
export function sentence(
  event: Event,
  before: Known,
  after: Known,
  header: ShownHeader,
  language: Language,
): string {
  const say = (algorithmOf(header).sentences[event.e] ??
    commonSentences[event.e as keyof CommonEvents]) as Bilingual<Say> | undefined;
  if (say === undefined) throw new Error(`no sentence of ${event.e}`);
  const words = new Words(before, after, header, texts[language], rulesOf[language]);
  return withoutDoubledSigns(say[language](event, words));
}
