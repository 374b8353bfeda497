import { element, writable } from '../base/markup.js';
import { texts } from '../i18n/index.js';
import type { Language } from '../language/language.js';
import { tolerance } from './grade.js';
import { columnsOf, crossing, none, parts as forms } from './question.js';
import type { Asks, Option, Part, Question } from './question.js';
import { sayNone, sayNoted, sayValue } from './say.js';

/** Text as HTML of a Cloze question, escaped so that nothing in it is markup, a choice, or input for Moodle's filters. */
export function inert(text: string): string {
  return writable(text).replace(/[&<>"'{}~#\\=%@$]/g, (sign) => `&#${sign.charCodeAt(0)};`);
}

/** A choice to make, and the text before it. */
interface Choice {
  readonly label: string;
  readonly options: readonly string[];
  /** The index of the right option. */
  readonly right: number;
}

/** Whether a row has a place for each thing that the part is about. */
const isByGiven = ({ asks }: Part): boolean => asks === 'signs' || asks === 'cornerSigns';

function sayOption(asks: Asks, option: Option, language: Language): string {
  return option.value === none
    ? sayNone(asks, language)
    : sayNoted(forms[asks][1], option, language);
}

function sayPlace(asks: Asks, { value }: Option, language: Language): string {
  const { crossing: ofEdge } = texts[language].predict;
  return value === crossing ? ofEdge : sayValue(forms[asks][1], value, language);
}

/**
 * The choices of a part, one for each place of a row. There are as many as the row could have, so that they do not reveal
 * its length.
 */
function placesOf(part: Part, language: Language): readonly Choice[] {
  const { asks, options, right, given = [] } = part;
  const { ends } = texts[language].predict;
  const labels = isByGiven(part)
    ? given.map((each) => sayNoted(each.of, each, language))
    : Array.from({ length: Math.max(options.length, right.length) }, (_, i) => `${i + 1}.`);
  const values = options.map(({ value }) => value);
  const said = options.map((option) => sayPlace(asks, option, language));
  return labels.map((label, i) => ({
    label,
    options: [...said, ends[asks as keyof typeof ends]],
    right: i < right.length ? values.indexOf(right[i] ?? none) : values.length,
  }));
}

function choicesOf(part: Part, language: Language): readonly Choice[] {
  const { asks, options, right } = part;
  const [form] = forms[asks];
  if (form === 'row') return placesOf(part, language);
  const said = options.map((option) => sayOption(asks, option, language));
  if (form === 'one') {
    return [
      { label: '', options: said, right: options.findIndex(({ value }) => value === right[0]) },
    ];
  }
  const { yes, no } = texts[language].page;
  return options.map(({ value }, i) => ({
    label: said[i] ?? '',
    options: [yes, no],
    right: right.includes(value) ? 0 : 1,
  }));
}

/** The notation of Cloze, which decodes a choice once before using it as HTML. */
function gap({ options, right }: Choice, weight: number, type: string): string {
  const written = options.map((option, i) => `${i === right ? '=' : ''}${inert(inert(option))}`);
  return `{${weight}:${type}:${written.join('~')}}`;
}

const row = (cells: readonly string[]): string =>
  element('tr', [], cells.map((cell) => element('td', [], cell)).join(''));

const table = (rows: readonly string[]): string =>
  element('table', [], element('tbody', [], rows.join('')));

/** A table of numbers to be filled in, with the names of its rows and columns. */
function tableHtml(part: Part, weight: number, language: Language): string {
  const { right } = part;
  const columns = columnsOf(part);
  const { entry, columns: names } = texts[language].predict.table;
  const gaps = right.map((value) => `{${weight}:NUMERICAL:=${value}:${tolerance}}`);
  const rows = Array.from({ length: right.length / columns.length }, (_, i) => i);
  return table([
    row(['', ...columns.map((each) => inert(names[each]))]),
    ...rows.map((i) =>
      row([
        rows.length === 1 ? '' : inert(entry(i + 1)),
        ...gaps.slice(i * columns.length, (i + 1) * columns.length),
      ]),
    ),
  ]);
}

function choicesHtml(part: Part, weight: number, language: Language): string {
  const choices = choicesOf(part, language);
  if (forms[part.asks][0] === 'one') {
    return element('div', [], choices.map((one) => gap(one, weight, 'MULTICHOICE_V')).join(''));
  }
  return table(
    choices.map((choice) => row([inert(choice.label), gap(choice, weight, 'MULTICHOICE')])),
  );
}

function partHtml(part: Part, weight: number, language: Language): string {
  const { asks, given = [] } = part;
  const about = isByGiven(part) ? [] : given.map((each) => sayNoted(each.of, each, language));
  const asked = `<strong>${inert(texts[language].predict.asks[asks])}</strong>`;
  const paragraph = element('p', [], [asked, inert(about.join('; '))].filter(Boolean).join(' '));
  const answer = forms[asks][0] === 'table' ? tableHtml : choicesHtml;
  return paragraph + answer(part, weight, language);
}

const commonDivisor = (a: number, b: number): number => (b === 0 ? a : commonDivisor(b, a % b));
const commonMultiple = (a: number, b: number): number => (a * b) / commonDivisor(a, b);

/** How many gaps a part has. */
const gapsOf = (part: Part, language: Language): number =>
  forms[part.asks][0] === 'table' ? part.right.length : choicesOf(part, language).length;

/** The parts of a question as HTML with choices in the notation of Moodle's Cloze; all parts have the same weight. */
export function clozeOf({ parts }: Question, language: Language): string {
  const counts = parts.map((part) => gapsOf(part, language));
  const whole = counts.reduce(commonMultiple, 1);
  return parts.map((part, i) => partHtml(part, whole / (counts[i] ?? 1), language)).join('');
}
