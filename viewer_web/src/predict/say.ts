import { inOneLine } from '../language/stated.js';
import { texts } from '../i18n/index.js';
import type { Language } from '../language/language.js';
import { withoutDoubledSigns } from '../language/words.js';
import type { Relation } from '../language/words.js';
import type { Trace } from '../replay/trace.js';
import type { Case } from '../time/course.js';
import type { Corner } from '../trace/values.js';
import { between, columnsOf, none, parts } from './question.js';
import type {
  Abouts,
  Asks,
  Becomes,
  Kind,
  Of,
  Option,
  Part,
  Question,
  relations,
  tests,
} from './question.js';
import type { Wrong } from './sheet.js';

type Lies = (typeof relations)[number];
type Test = (typeof tests)[number];

type Say = (value: string, language: Language) => string;

const itself = (value: string): string => value.replace('-', '−');

const words: Readonly<Record<Of, Say>> = {
  case: (value, language) => texts[language].strip.cases[value as Case],
  polygon: (value) => value,
  window: itself,
  corner: (value, language) => texts[language].places[value as Corner],
  relation: (value, language) => `${value} ${texts[language].predict.relations[value as Relation]}`,
  yes: (value, language) => texts[language].page[value === 'yes' ? 'yes' : 'no'],
  lies: (value, language) => texts[language].predict.lies[value as Lies],
  test: (value, language) => `${value}: ${texts[language].predict.tests[value as Test]}`,
  number: (value, language) => texts[language].numbers.short(Number(value)),
  sign: itself,
  vertex: itself,
  point: (value) => value,
  edge: (value, language) => texts[language].predict.edge(value),
  segment: (value) => value,
  depth: itself,
  column: (value, language) => texts[language].predict.column(value),
  horizon: (value, language) => texts[language].predict.horizons[value as 'upper' | 'lower'],
  spot: (value, language) =>
    value === between ? texts[language].predict.between : texts[language].predict.overColumn(value),
  next: (value, language) => texts[language].predict.becomes[value as Becomes],
};

/** The text of a question of its kind. */
export function sayIntro<K extends Kind>({ kind, about }: Question<K>, language: Language): string {
  const word = texts[language].predict.intro[kind] as (of: Abouts[Kind]) => string;
  return word(about);
}

/** The text of an option, without its note. */
export const sayValue = (of: Of, value: string, language: Language): string =>
  words[of](value, language);

/** The meaning of no polygon for a part. */
export function sayNone(asks: Asks, language: Language): string {
  const { noPolygon } = texts[language].predict;
  return noPolygon[asks === 'wins' ? 'wins' : 'hides'];
}

/** The note of an option; null if there is none. */
export const sayNote = ({ note }: Option, language: Language): string | null =>
  note === undefined ? null : withoutDoubledSigns(note(texts[language]));

/** Whether an option is shown by its note alone. */
export const isItsNote = (of: Of): boolean => of === 'depth' || of === 'point' || of === 'window';

/** An option and its note in one line. */
export function sayNoted(of: Of, option: Option, language: Language): string {
  const said = words[of](option.value, language);
  const note = sayNote(option, language);
  if (note === null) return said;
  return isItsNote(of) ? note : `${said}: ${note}`;
}

/** An entry of an answer to a part, in words. */
export function sayEntry({ asks, options }: Part, value: string, language: Language): string {
  if (value === none) return sayNone(asks, language);
  const [, of] = parts[asks];
  const option = options.find((each) => each.value === value);
  return option !== undefined && isItsNote(of)
    ? sayNoted(of, option, language)
    : words[of](value, language);
}

/** A value in a sentence: in the options a relation is a sign and a word, in an answer only the word. */
export function sayAnswer(part: Part, value: string, language: Language): string {
  const [, of] = parts[part.asks];
  return of === 'relation'
    ? texts[language].predict.relations[value as Relation]
    : sayEntry(part, value, language);
}

/** The name of a cell of a table: its column and, if there are several, its row, from 1. */
export function sayCell(part: Part, cell: number, language: Language): string {
  const { entry, columns: names } = texts[language].predict.table;
  const columns = columnsOf(part);
  const column = columns[cell % columns.length];
  const name = column === undefined ? '' : names[column];
  const isOnly = part.right.length === columns.length;
  return isOnly ? name : `${entry(Math.floor(cell / columns.length) + 1)}, ${name}`;
}

/** A cell of a table, with the right number in it. */
export const sayRightCell = (part: Part, cell: number, language: Language): string =>
  `${sayCell(part, cell, language)}: ${sayEntry(part, part.right[cell] ?? '', language)}`;

/** The right answer to a part, in words. */
export function sayRight(part: Part, language: Language): string {
  const { asks, right } = part;
  const [form] = parts[asks];
  const say = (value: string): string => sayAnswer(part, value, language);
  if (right.length === 0) return texts[language].predict.empty;
  if (form === 'table') return right.map((_, i) => sayRightCell(part, i, language)).join('; ');
  return form === 'row' ? right.map(itself).join(' ') : right.map(say).join(', ');
}

/** The part of a step that answers a question. */
export interface Reason {
  readonly step: number;
  readonly said: string;
}

/** The reasons for the answer to a question. */
export function reasonsOf(
  { timeline }: Trace,
  { because }: Question,
  language: Language,
): readonly Reason[] {
  return because.map((step) => ({ step, said: inOneLine(timeline.sentence(step, language)) }));
}

/** The step that decides the first wrong entry of an answer to a part. */
export const stepAgainst = ({ until }: Question, part: Part, { value, at }: Wrong): number =>
  part.decidedBy?.(value, at) ?? until;
