import type { FirstTerms } from '../i18n/glossary.js';
import type { Language } from '../language/language.js';
import type { ReaderTexts } from '../language/texts.js';
import type { AddressOf } from './links.js';
import type { LessonStory, Pin, Story } from './story.js';

/** What the rendering of a story needs from the page. */
export interface TextContext {
  readonly lesson: LessonStory;
  readonly texts: ReaderTexts;
  readonly story: Story;
  /** The name of the place of the current pin. */
  readonly current: string | null;
  /** The address of a lesson, or of a place in it; null if the page has no such lesson. */
  readonly addressOf: AddressOf;
  /** A description of the run of a pin. */
  readonly runOf: (pin: Pin) => string;
  /** The terms that occurred in the section so far; null where none is explained, as in a link. */
  readonly terms: FirstTerms | null;
  /** The address of a figure in SVG. */
  readonly drawingOf: (svg: string) => string;
  /** Whether the text stands a second time in the page, for print only: then its pins are no places. */
  readonly isCopy?: boolean;
  readonly language: Language;
}

/** Explains no term, as in a heading, a caption or a link. */
export const withoutTerms = (context: TextContext): TextContext => ({ ...context, terms: null });

/** Makes no places, for a copy of a text that is printed elsewhere. */
export const withoutPlaces = (context: TextContext): TextContext => ({
  ...withoutTerms(context),
  isCopy: true,
});
