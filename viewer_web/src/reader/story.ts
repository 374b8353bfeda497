import {
  bool,
  count,
  dictionary,
  list,
  oneKind,
  formatOf,
  oneOf,
  optional,
  parseJson,
  part,
  text,
} from '../trace/check.js';
import type { Check } from '../trace/check.js';
import { Refusal, describe } from '../trace/refusal.js';
import { stateParts } from '../algorithm/shows.js';
import type { StatePart } from '../algorithm/shows.js';
import { edition } from '../trace/editions.js';
import type { Edition } from '../trace/editions.js';
import { inEachLanguage } from '../language/language.js';
import type { Bilingual, Language } from '../language/language.js';
import { boundedText, toUtf8 } from '../base/file.js';
import { placesIn } from './places.js';
import type { Mark } from './places.js';

/** A piece of a line: text, or an element in it. */
export type Inline =
  | string
  | { readonly is: 'emphasis' | 'strong'; readonly text: Inlines }
  | { readonly is: 'code'; readonly text: string }
  | { readonly is: 'formula'; readonly tex: string }
  | PinLink
  | { readonly is: 'lesson'; readonly id: string; readonly text: Inlines }
  | { readonly is: 'link'; readonly url: string; readonly text: Inlines };
export type Inlines = readonly Inline[];

/** A text with a link to a step of a run. */
export interface PinLink {
  readonly is: 'pin';
  readonly pin: string;
  readonly text: Inlines;
}

export interface Heading {
  readonly is: 'heading';
  readonly level: number;
  readonly text: Inlines;
}

export type Block =
  | Heading
  | { readonly is: 'paragraph'; readonly text: Inlines }
  | { readonly is: 'list'; readonly ordered: boolean; readonly items: readonly Blocks[] }
  | { readonly is: 'quote'; readonly blocks: Blocks }
  | Question
  | { readonly is: 'code'; readonly language: string; readonly text: string }
  | { readonly is: 'formula'; readonly tex: string }
  | Figure
  | Table
  | PrintedListing;
export type Blocks = readonly Block[];

/** A question to think about, or an exercise to work out by hand. */
export interface Question {
  readonly is: 'question' | 'exercise';
  /** Its number among those of its kind, from 1. */
  readonly number: number;
  readonly blocks: Blocks;
  /** Absent if the lesson was built without answers. */
  readonly answer?: Blocks;
}

/** Procedures, and single lines of procedures, by their names in the listings. */
export interface PrintedListing {
  readonly is: 'listing';
  readonly edition: Edition;
  readonly names: readonly string[];
}

export interface Figure {
  readonly is: 'figure';
  readonly caption: Inlines;
  /** The command that makes the figure. */
  readonly command: string;
  /** The name of the lesson's figure, if it exists. */
  readonly file: string;
}

export interface Table {
  readonly is: 'table';
  readonly head: readonly Inlines[];
  readonly align: readonly Align[];
  readonly rows: readonly (readonly Inlines[])[];
}
const alignments = ['left', 'right', 'center', ''] as const;
export type Align = (typeof alignments)[number];

/** The text of a lesson in one language. */
export interface Story {
  readonly title: Inlines;
  /** What the reader can do after the lesson. */
  readonly goals: readonly Inlines[];
  readonly blocks: Blocks;
  /** Figures as SVG, by name. */
  readonly figures: ReadonlyMap<string, string>;
  /** The names of its headings and pins in reading order, which an address uses. */
  readonly places: ReadonlyMap<Mark, string>;
}

/** A step of one of the lesson's runs. */
export interface Pin {
  readonly run: string;
  readonly step: number;
}

/** A publication on which a lesson rests. */
export interface Source {
  readonly authors: string;
  readonly year: string;
  readonly title: string;
  /** The journal, the report or the publisher. */
  readonly in: string;
  readonly url?: string;
  /** The chapter to read; absent for all of it. */
  readonly chapter?: string;
  /** A translation, as a reference of its own. */
  readonly translations?: Partial<Readonly<Record<Language, string>>>;
}

/** Another lesson, which comes first. */
export interface Prerequisite {
  readonly id: string;
  readonly title: Bilingual<string>;
}

/** A lesson as `vidno lesson build` writes it: its text in both languages, and the pins that the text links to. */
export interface LessonStory {
  readonly id: string;
  /** The file of each run. */
  readonly traces: ReadonlyMap<string, string>;
  readonly pins: ReadonlyMap<string, Pin>;
  /** The parts of the state to show beside the text. */
  readonly shows?: readonly StatePart[];
  /** The minutes that it takes in class, without the exercises. */
  readonly minutes?: number;
  readonly prerequisites?: readonly Prerequisite[];
  /** What the reader must know besides. */
  readonly assumes?: Bilingual<string>;
  readonly sources?: readonly Source[];
  readonly story: Bilingual<Story>;
}

const listed = new WeakMap<LessonStory, readonly string[]>();
const nothingListed: readonly string[] = [];

/** The procedures and the single lines that a lesson's listings print. A lesson always gives the same list. */
export function listedIn(lesson: LessonStory | null | undefined): readonly string[] {
  if (!lesson) return nothingListed;
  const names =
    listed.get(lesson) ??
    lesson.story.en.blocks.flatMap((block) => (block.is === 'listing' ? block.names : []));
  listed.set(lesson, names);
  return names;
}

/** Accepts web addresses only: `javascript:` and the like are addresses as well. */
const webAddress: Check<string> = (value, path) => {
  const address = text(value, path);
  if (/^https?:\/\//.test(address)) return address;
  throw new Refusal(path, 'noWebAddress', describe(value));
};

const inlines: Check<Inlines> = (value, path) => list(inline)(value, path);

const noWords = oneKind({
  emphasis: { text: inlines },
  strong: { text: inlines },
  code: { text },
  formula: { tex: text },
  pin: { pin: text, text: inlines },
  lesson: { id: text, text: inlines },
  link: { url: webAddress, text: inlines },
});

const inline: Check<Inline> = (value, path) =>
  typeof value === 'string' ? value : noWords(value, path);

const blocks: Check<Blocks> = (value, path) => list(block)(value, path);

const level = oneOf(2, 3);
const asked = { number: count, blocks, answer: optional(blocks) };

const block: Check<Block> = oneKind({
  heading: { level, text: inlines },
  paragraph: { text: inlines },
  list: { ordered: bool, items: list(blocks) },
  quote: { blocks },
  question: asked,
  exercise: asked,
  listing: { edition, names: list(text) },
  code: { language: text, text },
  formula: { tex: text },
  figure: { caption: inlines, command: text, file: text },
  table: {
    head: list(inlines),
    align: list(oneOf(...alignments)),
    rows: list(list(inlines)),
  },
});

const written = part({
  title: inlines,
  goals: optional(list(inlines)),
  blocks,
  figures: optional(dictionary(text)),
});
const story: Check<Story> = (value, path) => {
  const { figures = new Map<string, string>(), goals = [], ...read } = written(value, path);
  return { ...read, goals, figures, places: placesIn({ ...read, goals }) };
};

const inEach = part(inEachLanguage(() => text));

const source = part({
  authors: text,
  year: text,
  title: text,
  in: text,
  url: optional(webAddress),
  chapter: optional(text),
  translations: optional(part(inEachLanguage(() => optional(text)))),
});

const lesson = part({
  format: formatOf('vidno-lesson/1'),
  id: text,
  traces: dictionary(text),
  pins: dictionary(part({ run: text, step: count })),
  shows: optional(list(oneOf(...stateParts))),
  minutes: optional(count),
  prerequisites: optional(list(part({ id: text, title: inEach }))),
  assumes: optional(inEach),
  sources: optional(list(source)),
  story: part(inEachLanguage(() => story)),
});

/** Checks a lesson; refuses anything else, including pins that lead nowhere. */
export function lessonStory(value: unknown): LessonStory {
  const read = lesson(value, '');
  for (const [name, { run }] of read.pins) {
    if (!read.traces.has(run)) throw new Refusal(`pins.${name}.run`, 'noSuchRun', run);
  }
  for (const [language, { places }] of Object.entries(read.story)) {
    for (const mark of places.keys()) {
      if (mark.is === 'pin' && !read.pins.has(mark.pin)) {
        throw new Refusal(`story.${language}`, 'noSuchPin', mark.pin);
      }
    }
  }
  return read;
}

/** A few bytes may unpack to very many. */
const longestStory = 16_000_000;

/** The lesson in a JSON file packed by gzip. Throws a Refusal if it is not a lesson, or else the browser's error. */
export async function readStory(file: Blob): Promise<LessonStory> {
  const stream = file
    .stream()
    .pipeThrough<Uint8Array<ArrayBuffer>>(new DecompressionStream('gzip'));
  return lessonStory(parseJson(await boundedText(stream.pipeThrough(toUtf8()), longestStory)));
}
