import listings from '../../../trace/listings/listings.json' with { type: 'json' };
import type { Language } from '../language/language.js';
import type { Method } from '../trace/events.js';
import type { Edition } from '../trace/editions.js';
import type { Header } from '../trace/header.js';
import { speaks } from './notes.js';

/** A line of a procedure as it is shown. */
export interface Line {
  readonly at: string;
  readonly indent: number;
  readonly text: string;
  /** The defects of the printed text in this line, if that is what is shown. */
  readonly defects: readonly string[];
  /** Whether it ever says something that is written beside it. */
  readonly speaks: boolean;
}

export interface Listing {
  readonly name: string;
  readonly title: string;
  readonly takes: string;
  readonly lines: readonly Line[];
}

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

const sources: readonly Source[] = listings.procedures;

function line(source: SourceLine, edition: Edition, language: Language): Omit<Line, 'speaks'> {
  const printed = edition === 'printed' ? source.printed : undefined;
  const { at, indent } = source;
  return { at, indent, text: (printed ?? source)[language], defects: printed?.defects ?? [] };
}

/** The procedures of a method in the order in which they call one another. */
export const namesOf = (method: Method): readonly string[] => listings.methods[method];

/** What they say in the run's edition, and where its level has values to write beside it. */
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
