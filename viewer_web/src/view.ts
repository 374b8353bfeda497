import { sentence, texts } from './i18n/index.js';
import type { Language } from './i18n/language.js';
import type { PageTexts } from './i18n/texts.js';
import { valuesInPlay } from './listing/in-play.js';
import type { Pixel } from './picture/pixel.js';
import type { Screen } from './state/screen.js';
import type { Values } from './state/state.js';
import type { Event } from './trace/events.js';
import type { Header } from './trace/header.js';
import type { Trace } from './trace/trace.js';

/** A step as the components show it: what happened, and what was before and after it. */
export interface View {
  readonly header: Header;
  readonly step: number;
  readonly length: number;
  readonly event: Event | null;
  readonly before: Values;
  readonly after: Values;
  readonly screen: Screen;
  /** What each line last said, by its label. */
  readonly inPlay: ReadonlyMap<string, string>;
  readonly language: Language;
  readonly texts: PageTexts;
  readonly sentence: string;
  /** The pixel whose history is asked for. */
  readonly pixel: Pixel | null;
}

export function viewOf(trace: Trace, step: number, language: Language, pixel: Pixel | null): View {
  const { header, timeline } = trace;
  const before = timeline.seek(Math.max(0, step - 1)).values;
  const { values: after, screen } = timeline.seek(step);
  const event = timeline.event(step);
  const { page } = texts[language];
  return {
    header,
    step,
    length: timeline.length,
    event,
    before,
    after,
    screen,
    inPlay: valuesInPlay(trace, step),
    language,
    texts: page,
    pixel,
    sentence: event ? sentence(event, before, after, header.scene, language) : page.start,
  };
}
