import type { RegionLayer } from '../weiler-atherton/shapes.js';
import type { PluralForms } from './words.js';

/** The texts of runs with regions. */
export interface RegionTexts {
  readonly lists: string;
  readonly list: string;
  readonly clip: string;
  readonly ground: string;
  readonly inside: string;
  readonly outside: string;
  readonly behind: string;
  readonly nearer: string;
  readonly visible: string;
  /** How many of these there are. */
  readonly shown: string;
  readonly area: string;
  readonly vertices: PluralForms;
  readonly pieces: string;
  readonly loops: PluralForms;
  readonly layers: Readonly<Record<RegionLayer, string>>;
  readonly layersName: string;
}
