import { fileIn } from '../base/base64.js';
import { bool, list, oneOf, optional, part, text } from '../trace/check.js';
import type { Checked } from '../trace/check.js';
import { edition } from '../trace/editions.js';
import { details, methods } from '../trace/events.js';

/**
 * What `index.json` beside the lessons' traces says; the build embeds it together with them. `vidno page` may put a scene
 * in the place of a trace: what is said of the run is then how to run it.
 */
const entry = part({
  file: text,
  method: oneOf(...methods),
  kernel: text,
  edition,
  detail: oneOf(...details),
  /** Whether a scene is run with every decision held against exact arithmetic. */
  check: optional(bool),
  /** What it shows. */
  title: optional(part({ en: text, ru: text })),
});

const lessonList = list(
  part({
    id: text,
    title: part({ en: text, ru: text }),
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

/** The lessons that stand in the page as blocks of data, which no browser executes. */
export function embeddedLessons(page: Document): readonly Lesson[] {
  const block = page.getElementById('vidno-lessons');
  return block === null ? [] : lessonList(JSON.parse(block.textContent), '');
}

/** The file of this name that the page brings along. */
export function embeddedFile(page: Document, file: string): Blob | null {
  const blocks = page.querySelectorAll<HTMLScriptElement>('script[data-vidno-file]');
  const block = [...blocks].find((each) => each.dataset['vidnoFile'] === file);
  return block === undefined ? null : fileIn(block);
}
