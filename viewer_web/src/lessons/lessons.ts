import { fileIn } from '../base/base64.js';
import { inEachLanguage } from '../language/language.js';
import { bool, list, oneOf, optional, part, text } from '../trace/check.js';
import type { Checked } from '../trace/check.js';
import { edition } from '../trace/editions.js';
import { details, methods } from '../trace/events.js';

const textInEach = part(inEachLanguage(() => text));

/**
 * An entry of `index.json`, beside the lessons' traces; the build embeds them together. `vidno page` may replace a trace by
 * a scene: the entry then also states how to run it.
 */
const entry = part({
  file: text,
  method: oneOf(...methods),
  kernel: text,
  edition,
  detail: oneOf(...details),
  /** Whether every decision of the scene's run is compared with exact arithmetic. */
  check: optional(bool),
  /** The title of the run. */
  title: optional(textInEach),
});

const lessonList = list(
  part({
    id: text,
    title: textInEach,
    traces: list(entry),
    story: optional(text),
  }),
);

export type LessonTrace = Checked<typeof entry>;
export type Lesson = Checked<typeof lessonList>[number];

/** The name of an embedded trace in the page's address. */
export function idOf({ file }: LessonTrace): string {
  return file.replace(/\.(json|jsonl|jsonl\.gz)$/, '');
}

/** The lessons in the page. They are blocks of data, which no browser executes. */
export function embeddedLessons(page: Document): readonly Lesson[] {
  const block = page.getElementById('vidno-lessons');
  return block === null ? [] : lessonList(JSON.parse(block.textContent), '');
}

/** The block with a file that the page contains, by name. It may have the content of several files. */
export function blockOf(page: Document, file: string): HTMLScriptElement | undefined {
  const blocks = page.querySelectorAll<HTMLScriptElement>('script[data-vidno-file]');
  const block = [...blocks].find((each) => each.dataset['vidnoFile'] === file);
  const same = block?.dataset['vidnoSame'];
  return same === undefined ? block : blockOf(page, same);
}

/** A file that the page contains, by name. */
export function embeddedFile(page: Document, file: string): Blob | null {
  const block = blockOf(page, file);
  return block === undefined ? null : fileIn(block);
}
