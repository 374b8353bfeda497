import { algorithmOf } from '../algorithm/algorithm.js';
import { texts } from '../i18n/index.js';
import { languages } from '../language/language.js';
import type { Language } from '../language/language.js';
import { cases } from '../time/course.js';
import { eventsOf, kinds } from '../trace/events.js';
import type { Method, Procedure } from '../trace/events.js';
import type { Header } from '../trace/header.js';

/** What can be searched for. */
export const facets = ['polygon', 'curve', 'case', 'row', 'procedure'] as const;
export type Facet = (typeof facets)[number];

/** The meaning of a term: some polygons or curves by their indices in the scene, or some cases, rows or procedures. */
export type Meaning =
  | { readonly facet: 'procedure'; readonly values: ReadonlySet<Procedure> }
  | { readonly facet: Exclude<Facet, 'procedure'>; readonly values: ReadonlySet<number> };

/** A word of a query, such as `B` or `case:split`. */
export interface Term {
  /** The text as typed. */
  readonly word: string;
  /** Empty if nothing has that name. */
  readonly meanings: readonly Meaning[];
}

/** The procedures that runs of a method call. */
export function proceduresOf(method: Method): readonly Procedure[] {
  const all = eventsOf[method].flatMap((name) => kinds[name].resultOf ?? []);
  return [...new Set(all)];
}

/** The facets that the runs of a header have. */
export function facetsOf(header: Header): readonly Facet[] {
  const { lanes, outline } = algorithmOf(header);
  const own: Readonly<Partial<Record<Facet, boolean>>> = {
    polygon: header.scene.curves === null,
    curve: lanes.first === 'curves',
    case: lanes.first === 'cases',
    row: outline.parts.length > 0,
  };
  return facets.filter((facet) => own[facet] !== false);
}

const pattern = /(?:([^\s:"]+):)?("[^"]*"?|\S+)/gu;

/**
 * The terms of a query. Spaces separate them, quotes enclose a term with spaces, and each may begin with a facet's name.
 */
export function termsOf(query: string, header: Header): readonly Term[] {
  return [...query.matchAll(pattern)].map(([word, name, quoted = '']) => {
    const text = quoted.replaceAll('"', '');
    const facet = name === undefined ? null : facetNamed(name);
    if (name !== undefined && facet === null) return { word, meanings: plain(word, header) };
    return { word, meanings: facet === null ? plain(text, header) : meant(facet, text, header) };
  });
}

/** A query without one of its terms. */
export const without = (terms: readonly Term[], gone: Term): string =>
  terms.flatMap((term) => (term === gone ? [] : term.word)).join(' ');

/** A term with a single meaning, as text. A name is quoted if it has spaces; quotes in it are left out. */
export function written(facet: Facet, name: string, language: Language): string {
  const bare = name.replaceAll('"', '');
  return `${texts[language].outline.facets[facet]}:${/\s/u.test(bare) ? `"${bare}"` : bare}`;
}

const isSame = (one: string, other: string): boolean => one.toLowerCase() === other.toLowerCase();
const begins = (name: string, text: string): boolean =>
  name.toLowerCase().startsWith(text.toLowerCase());

/** The facet with that name in any language. */
const facetNamed = (name: string): Facet | null =>
  facets.find((facet) =>
    [facet, ...languages.map((language) => texts[language].outline.facets[facet])].some((each) =>
      isSame(each, name),
    ),
  ) ?? null;

/**
 * The meanings of a word without a facet: everything with exactly that name, or else polygons whose name begins with it.
 */
function plain(text: string, header: Header): readonly Meaning[] {
  const { polygons } = header.scene;
  const exact = new Set(polygons.flatMap(({ id }, i) => (id === text ? i : [])));
  const others = facetsOf(header)
    .filter((facet) => facet !== 'polygon')
    .flatMap((facet) => meant(facet, text, header));
  const found = [...polygonsMeant(exact), ...others];
  return found.length > 0 ? found : meant('polygon', text, header);
}

const polygonsMeant = (values: ReadonlySet<number>): readonly Meaning[] =>
  values.size === 0 ? [] : [{ facet: 'polygon', values }];

function meant(facet: Facet, text: string, header: Header): readonly Meaning[] {
  if (text === '' || !facetsOf(header).includes(facet)) return [];
  if (facet === 'procedure') {
    const values = new Set(proceduresOf(header.method).filter((name) => begins(name, text)));
    return values.size === 0 ? [] : [{ facet, values }];
  }
  const values = numbersOf(facet, text, header);
  return values.size === 0 ? [] : [{ facet, values }];
}

function numbersOf(
  facet: Exclude<Facet, 'procedure'>,
  text: string,
  { scene }: Header,
): ReadonlySet<number> {
  if (facet === 'polygon') {
    const names = scene.polygons.map(({ id }) => id.replaceAll('"', ''));
    const exact = names.flatMap((name, i) => (isSame(name, text) ? i : []));
    const like = (): readonly number[] => names.flatMap((name, i) => (begins(name, text) ? i : []));
    return new Set(exact.length > 0 ? exact : like());
  }
  if (facet === 'case') {
    const names = (i: number): readonly string[] => {
      const name = cases[i] ?? 'empty';
      return [name, ...languages.map((language) => texts[language].strip.cases[name])];
    };
    return new Set(cases.flatMap((_, i) => (names(i).some((name) => begins(name, text)) ? i : [])));
  }
  const number = /^[-−]?\d{1,9}$/u.test(text) ? Number(text.replace('−', '-')) : NaN;
  const isThere = facet === 'row' ? !Number.isNaN(number) : number in (scene.curves ?? []);
  return new Set(isThere ? [number] : []);
}

/** The meaning of a term in words. */
export function sayTerm({ meanings }: Term, { scene }: Header, language: Language): string {
  const { outline, strip } = texts[language];
  const most = 3;
  const said = meanings.map(({ facet, values }) => {
    const names = [...values].map((value) => {
      if (typeof value === 'string') return value;
      if (facet === 'polygon') return scene.polygons[value]?.id ?? '';
      return facet === 'case' ? strip.cases[cases[value] ?? 'empty'] : String(value);
    });
    const more = names.length > most ? ' …' : '';
    return `${outline.facets[facet]} ${names.slice(0, most).join(', ')}${more}`;
  });
  return said.join(' / ');
}
