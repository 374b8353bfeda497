import type { Layer } from '../curves/layers.js';
import type { CurveEvents } from '../trace/events.js';
import type { HistoryTexts } from './texts.js';
import type { Words } from './words.js';

/** What a run of curves has to say of its own. */
export interface CurveTexts {
  readonly curve: (curve: number) => string;
  readonly inHand: string;
  readonly segment: string;
  readonly edges: string;
  readonly left: string;
  readonly right: string;
  readonly columns: string;
  readonly column: string;
  readonly height: string;
  readonly upper: string;
  readonly lower: string;
  readonly looked: string;
  readonly lines: string;
  readonly flags: Readonly<Record<'above' | 'below' | 'hidden' | 'both', string>>;
  readonly layers: Readonly<Record<Layer, string>>;
  readonly layersName: string;
  readonly around: (column: number) => string;
  readonly history: CurveHistoryTexts;
}

/** What is said of a column and of all that happened over it. */
export type CurveHistoryTexts = Pick<
  HistoryTexts,
  'pixel' | 'at' | 'hint' | 'how' | 'forget' | 'entries' | 'outcomes' | 'painted' | 'unpainted'
>;

export type CurveSentences = {
  readonly [K in keyof CurveEvents]: (
    event: Extract<CurveEvents[keyof CurveEvents], { readonly e: K }>,
    words: Words,
  ) => string;
};
