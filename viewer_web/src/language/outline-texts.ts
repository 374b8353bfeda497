import type { Facet } from '../outline/query.js';
import type { PluralForms } from './words.js';

/** The texts of the outline of a run. */
export interface OutlineTexts {
  readonly title: string;
  readonly tree: string;
  readonly reading: string;
  /** Shown while the run waits for an answer. */
  readonly veiled: string;
  readonly rows: (first: string, last: string) => string;
  readonly noRows: string;
  readonly edges: PluralForms;
  readonly spans: PluralForms;
  readonly polygons: PluralForms;
  readonly list: (pieces: number, clip: string) => string;
  readonly visible: string;
  readonly inFront: (polygons: string) => string;
  readonly lines: PluralForms;
  readonly hidden: string;
  readonly search: string;
  readonly example: (terms: string) => string;
  readonly facets: Readonly<Record<Facet, string>>;
  readonly nothing: (word: string) => string;
  readonly hits: PluralForms;
  readonly hitOf: (hit: string, hits: string) => string;
  readonly noHits: string;
  readonly searching: string;
  readonly nextHit: string;
  readonly previousHit: string;
  readonly remove: (term: string) => string;
}
