import { crossing, parts as forms } from './question.js';
import type { Part, Question } from './question.js';
import { emptyRow, isRightNumber, typedNumber, typedRow } from './grade.js';
import type { Answer } from './grade.js';

/** What the reader has entered in answer to one part, and the hints taken for it. */
export interface Entry {
  /** The chosen values; for a row, its typed text; for a table, the typed text of each cell. */
  readonly chosen: readonly string[];
  readonly hints: number;
  /** The options that hints have ruled out. */
  readonly ruledOut: readonly string[];
  /** The outcome of the last hint: the value that it put right, in a table its cell; null if there was nothing to put right. */
  readonly hinted?: string | null;
}

/** The entries for all parts of a question. */
export type Sheet = readonly Entry[];

export const emptySheet = ({ parts }: Question): Sheet =>
  parts.map(() => ({ chosen: [], hints: 0, ruledOut: [] }));

/** The text of each cell of a table. */
const cellsOf = ({ right }: Part, { chosen }: Pick<Entry, 'chosen'>): readonly string[] =>
  right.map((_, i) => chosen[i] ?? '');

const typedOf = (part: Part, { chosen }: Entry): readonly string[] =>
  typedRow(part, chosen[0] ?? '') ?? [];

const written = (row: readonly string[]): readonly string[] => [
  row.length === 0 ? emptyRow : row.join(' '),
];

/** The answer on a sheet; null for each part without one. */
export function answerOf({ parts }: Question, sheet: Sheet): Answer {
  return parts.map((part, i) => {
    const chosen = sheet[i]?.chosen ?? [];
    const [form] = forms[part.asks];
    if (form === 'row') return typedRow(part, chosen[0] ?? '');
    if (form === 'table') {
      const cells = cellsOf(part, { chosen });
      return cells.some((text) => typedNumber(text) === null) ? null : cells;
    }
    return form === 'one' && chosen.length === 0 ? null : chosen;
  });
}

/** Whether a value of a row may occur in it only once. */
const isUnique = ({ asks }: Part, value: string): boolean =>
  forms[asks][1] !== 'sign' && value !== crossing;

/** The entry after an option is chosen once more: it replaces another one, is turned on or off, or continues the row. */
export function pressed(part: Part, entry: Entry, value: string): Entry {
  const { chosen } = entry;
  const [form] = forms[part.asks];
  if (form === 'one') return { ...entry, chosen: [value] };
  const isIn = (form === 'row' ? typedOf(part, entry) : chosen).includes(value);
  const removes = isIn && (form === 'some' || isUnique(part, value));
  const old = form === 'row' ? typedOf(part, entry) : chosen;
  const now = removes ? old.filter((each) => each !== value) : [...old, value];
  return { ...entry, chosen: form === 'row' && now.length > 0 ? written(now) : now };
}

/** The entry after text was typed into a cell of a table. */
export function filledIn(part: Part, entry: Entry, cell: number, text: string): Entry {
  return { ...entry, chosen: cellsOf(part, entry).map((old, i) => (i === cell ? text : old)) };
}

/** The share of a part's point that each hint costs. */
export function hintCost({ asks, options, right }: Part): number {
  const { length } = right;
  const counts = { one: options.length - 1, some: options.length, row: length, table: length };
  return 1 / Math.max(1, counts[forms[asks][0]]);
}

/** The first wrong entry of an answer to a part: its value, and its position in a row; null if it is right. */
export function firstWrong(part: Part, given: readonly string[]): Wrong | null {
  const { asks, options, right } = part;
  const [form] = forms[asks];
  if (form === 'row') {
    const at = Array.from({ length: Math.max(given.length, right.length) }).findIndex(
      (_, i) => given[i] !== right[i],
    );
    return at < 0 ? null : { value: right[at] ?? null, at };
  }
  if (form === 'table') {
    const at = right.findIndex((value, i) => !isRightNumber(given[i] ?? '', value));
    return at < 0 ? null : { value: right[at] ?? null, at };
  }
  if (form === 'one') {
    return given[0] === right[0] ? null : { value: right[0] ?? null, at: 0 };
  }
  const wrong = options.find(({ value }) => given.includes(value) !== right.includes(value));
  return wrong === undefined ? null : { value: wrong.value, at: options.indexOf(wrong) };
}

export interface Wrong {
  /** Null if the row should have ended before. */
  readonly value: string | null;
  readonly at: number;
}

/** The entry after a hint: it rules out a wrong option of several, or puts the first wrong entry or cell right. */
export function hinted(part: Part, entry: Entry): Entry {
  const { chosen, ruledOut } = entry;
  const hints = entry.hints + 1;
  const { asks, options, right } = part;
  const [form] = forms[asks];
  if (form === 'one') {
    const wrong = options.find(({ value }) => !right.includes(value) && !ruledOut.includes(value));
    if (wrong === undefined) return { ...entry, hints, hinted: null };
    const { value } = wrong;
    const left = chosen.filter((each) => each !== value);
    return { chosen: left, hints, ruledOut: [...ruledOut, value], hinted: value };
  }
  const given = form === 'row' ? typedOf(part, entry) : chosen;
  const wrong = firstWrong(part, given);
  if (form === 'table') {
    if (wrong === null) return { ...entry, hints, hinted: null };
    const { at, value } = wrong;
    return { ...filledIn(part, entry, at, value ?? ''), hints, hinted: String(at) };
  }
  if (wrong === null && (form === 'some' || chosen.length > 0)) {
    return { ...entry, hints, hinted: null };
  }
  if (form === 'row') {
    const now = right.slice(0, (wrong?.at ?? 0) + 1);
    return { ...entry, chosen: written(now), hints, hinted: now.at(-1) ?? null };
  }
  return { ...pressed(part, entry, wrong?.value ?? ''), hints, hinted: wrong?.value ?? null };
}

/** The points for an answer: at most one for each part, less the cost of hints. */
export function pointsOf({ parts }: Question, right: readonly boolean[], sheet: Sheet): number {
  return parts.reduce((sum, part, i) => {
    const cost = (sheet[i]?.hints ?? 0) * hintCost(part);
    return right[i] === true ? sum + Math.max(0, 1 - cost) : sum;
  }, 0);
}
