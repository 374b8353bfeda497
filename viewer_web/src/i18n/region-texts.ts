import type { RegionLayer } from '../regions/layers.js';
import type { RegionEvents } from '../trace/events.js';
import type { Words } from './words.js';

/** What a run with regions has to say of its own. */
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
  readonly vertices: string;
  readonly pieces: string;
  readonly loops: (n: number) => string;
  readonly layers: Readonly<Record<RegionLayer, string>>;
  readonly layersName: string;
}

export type RegionSentences = {
  readonly [K in Exclude<keyof RegionEvents, 'row'>]: (
    event: RegionEvents[K],
    words: Words,
  ) => string;
};
