import type { ReaderTexts } from '../language/reader-texts.js';
import type { AddressOf } from './links.js';
import type { LessonStory, Pin, Story } from './story.js';

/** What a story needs to be told on the page. */
export interface Telling {
  readonly lesson: LessonStory;
  readonly texts: ReaderTexts;
  readonly story: Story;
  /** The pin that one has come to, by the name of its place. */
  readonly current: string | null;
  /** The address of a lesson, or of a place in it; null where the page has no such lesson. */
  readonly addressOf: AddressOf;
  /** The run of a pin, in words. */
  readonly runOf: (pin: Pin) => string;
  /** The address of a drawing, which is SVG. */
  readonly drawingOf: (svg: string) => string;
}
