import {
  editions,
  editionTitle,
  isFamily,
  isMistake,
  methodNames,
  methodSays,
  methodTitle,
} from '../trace/editions.js';
import type { Edition, NamedEdition } from '../trace/editions.js';
import type { Method, Variant } from '../trace/events.js';
import type { Language } from './language.js';

export type Names = Readonly<Record<Variant, string>>;

/** A text for each of some names. */
const textsOf = <K extends string>(
  names: readonly K[],
  text: (name: K) => string,
): Readonly<Record<K, string>> =>
  Object.fromEntries(names.map((name) => [name, text(name)])) as Record<K, string>;

/** The names of methods, editions and variants in a language, as the program has them. */
export const methodTitles = (language: Language): Readonly<Record<Method, string>> =>
  textsOf(methodNames, (method) => methodTitle(method)[language]);
export const editionTitles = (
  language: Language,
  mistake: string,
): Readonly<Record<NamedEdition, string>> =>
  textsOf(
    editions,
    (edition) => (isMistake(edition) ? mistake : '') + editionTitle(edition)[language],
  );

/**
 * The name of an edition, composed from the names of its deviations if it has none of its own: "as printed: X-W2, X-W4".
 */
export function editionName(
  names: Readonly<Record<NamedEdition, string>>,
  edition: Edition,
): string {
  if (Object.hasOwn(names, edition)) return names[edition as NamedEdition];
  const ids = edition
    .toUpperCase()
    .replace(/^PRINTED:/u, '')
    .split('+');
  return `${names.printed}: ${ids.join(', ')}`;
}
export const variantTitles = (language: Language): Names =>
  textsOf(methodNames.filter(isFamily) as Variant[], (method) => methodTitle(method)[language]);

/** The input and the rule of each method. */
export const methodRules = (language: Language): Readonly<Record<Method, string>> =>
  textsOf(methodNames, (method) => methodSays(method)[language]);

/** The names of variants, preceded by the name of the algorithm. */
export function prefixed(before: string, names: Names): Names {
  return Object.fromEntries(
    Object.entries(names).map(([variant, name]) => [variant, before + name]),
  ) as Names;
}
