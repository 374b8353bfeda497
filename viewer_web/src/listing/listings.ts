import listings from '../../../trace/listings/listings.json' with { type: 'json' };
import type { Language } from '../language/language.js';
import { engine } from '../replay/engine.js';
import { details, eventsOf, isOfAnyLine, kinds, numberOf } from '../trace/events.js';
import type { Detail, Method } from '../trace/events.js';
import { deviationOf, deviations, hasDefect, runsUnder } from '../trace/editions.js';
import type { Deviation, Edition } from '../trace/editions.js';
import type { Header } from '../trace/header.js';

/** A line of a procedure as shown. */
export interface Line {
  readonly at: string;
  readonly indent: number;
  readonly text: string;
  /** The defects of the printed text in this line, if that text is shown; ≠ for a usual mistake. */
  readonly defects: readonly string[];
  /** Whether the line can have a note beside it. */
  readonly speaks: boolean;
}

export interface Listing {
  readonly name: string;
  readonly title: string;
  readonly takes: string;
  readonly lines: readonly Line[];
}

/** A procedure, or some of its lines. */
export type Excerpt = Omit<Listing, 'lines'> & {
  readonly lines: readonly Omit<Line, 'speaks'>[];
};

type Both = Readonly<Record<Language, string>>;
interface SourceLine extends Both {
  readonly at: string;
  readonly indent: number;
  readonly printed?: Both & { readonly defects: readonly string[] };
}
interface Source {
  readonly name: string;
  readonly takes: string;
  readonly title: Both;
  readonly lines: readonly SourceLine[];
}

const sources = listings.procedures as readonly Source[];

function line(source: SourceLine, edition: Edition, language: Language): Omit<Line, 'speaks'> {
  const { at, indent, printed } = source;
  const deviation = deviationOf(edition);
  const mistaken = deviation?.reads[deviation.lines.indexOf(at)];
  if (mistaken !== undefined) return { at, indent, text: mistaken[language], defects: ['≠'] };
  const isOf = (id: string): boolean => hasDefect(edition, id.toLowerCase());
  // A line as printed without a defect of its own, such as a rounding, belongs to the whole text alone.
  const isWhole = edition === 'printed';
  const defects = (printed?.defects ?? []).filter((id) => isWhole || isOf(id));
  const shown = printed !== undefined && (isWhole || defects.length > 0) ? printed : source;
  return { at, indent, text: shown[language], defects };
}

/** The procedures of a method, in the order of their calls. */
export const namesOf = (method: Method): readonly string[] => listings.methods[method];

/** Whether a line can have a note at this level, except notes that any line may have. */
function speaks(label: string, method: Method, detail: Detail): boolean {
  return eventsOf[method].some((name) => {
    const { at, from } = kinds[name];
    return (
      !isOfAnyLine(name) &&
      engine().exports.has_note(numberOf.get(name) ?? -1) !== 0 &&
      details.indexOf(from) <= details.indexOf(detail) &&
      at?.includes(label) === true
    );
  });
}

/** The listings in the run's edition, with the lines that can have notes at its level. */
export function listingsOf(
  { method, edition, detail }: Pick<Header, 'method' | 'edition' | 'detail'>,
  language: Language,
): readonly Listing[] {
  return namesOf(method)
    .flatMap((name) => sources.filter((source) => source.name === name))
    .map(({ name, title, takes, lines }) => ({
      name,
      title: title[language],
      takes,
      lines: lines.map((each) => ({
        ...line(each, edition, language),
        speaks: speaks(each.at, method, detail),
      })),
    }));
}

/** The procedures and the single lines with these names, in the order of the listings. */
export function excerpt(
  names: readonly string[],
  edition: Edition,
  language: Language,
): readonly Excerpt[] {
  return sources.flatMap(({ name, title, takes, lines }) => {
    const shown = lines.filter(({ at }) => names.includes(name) || names.includes(at));
    if (shown.length === 0) return [];
    const printed = shown.map((each) => line(each, edition, language));
    return [{ name, title: title[language], takes, lines: printed }];
  });
}

/** The labels of a method's lines. */
function labelsOf(method: Method): readonly string[] {
  const names = new Set(namesOf(method));
  return sources
    .filter(({ name }) => names.has(name))
    .flatMap(({ lines }) => lines.map(({ at }) => at));
}

/** The lines of a method that a deviation changes. */
export function linesIn(method: Method, { lines }: Deviation): readonly string[] {
  const labels = labelsOf(method);
  return lines.filter((at) => labels.includes(at));
}

/** By line label, the ways in which a run could have that line wrong; empty if the run itself is not correct. */
export function wrongLines({
  method,
  edition,
  kernel,
}: Pick<Header, 'method' | 'edition' | 'kernel'>): ReadonlyMap<string, readonly Deviation[]> {
  const lines = new Map<string, readonly Deviation[]>();
  if (edition !== 'corrected') return lines;
  for (const label of labelsOf(method)) {
    const wrong = deviations.filter(
      (each) =>
        each.lines.includes(label) &&
        each.methods.includes(method) &&
        runsUnder(method, each.edition, kernel),
    );
    if (wrong.length > 0) lines.set(label, wrong);
  }
  return lines;
}
