import type { PluralForms } from '../../language/words.js';
export const outline = {
  title: 'Outline',
  tree: 'Outline of the run',
  reading: 'Reading the run…',
  /** Shown while the run waits for an answer. */
  veiled: 'There is no outline while the run stops for questions: it would show the answer.',
  rows: (first: string, last: string): string =>
    first === last ? `row ${first}` : `rows ${first} to ${last}`,
  noRows: 'no rows',
  edges: { one: 'edge', other: 'edges' } as PluralForms,
  spans: { one: 'span', other: 'spans' } as PluralForms,
  polygons: { one: 'polygon', other: 'polygons' } as PluralForms,
  list: (pieces: number, clip: string): string =>
    `list of ${pieces} ${pieces === 1 ? 'piece' : 'pieces'}, clip polygon ${clip}`,
  visible: 'visible',
  inFront: (polygons: string): string => `behind ${polygons}`,
  lines: { one: 'visible line', other: 'visible lines' } as PluralForms,
  hidden: 'hidden',
  search: 'Search the outline',
  example: (terms: string): string => `such as ${terms}`,
  facets: {
    polygon: 'polygon',
    curve: 'curve',
    case: 'case',
    row: 'row',
    procedure: 'procedure',
  },
  nothing: (word: string): string => `nothing here is called “${word}”`,
  hits: { one: 'hit', other: 'hits' } as PluralForms,
  hitOf: (hit: string, hits: string): string => `${hit} of ${hits}`,
  noHits: 'no hits',
  searching: 'searching…',
  nextHit: 'Next hit',
  previousHit: 'Previous hit',
  remove: (term: string): string => `Remove ${term}`,
};
