import type { Layer } from '../floating-horizon/shapes.js';
import type { N } from '../trace/values.js';
import type { HistoryTexts } from './texts.js';

/** The texts of runs of curves. */
export interface CurveTexts {
  readonly curve: (curve: number) => string;
  readonly inHand: string;
  readonly segment: string;
  readonly edges: string;
  readonly left: string;
  readonly right: string;
  readonly column: string;
  readonly upper: string;
  readonly lower: string;
  readonly looked: string;
  readonly lines: string;
  readonly flags: Readonly<Record<'above' | 'below' | 'hidden' | 'both', string>>;
  readonly layers: Readonly<Record<Layer, string>>;
  readonly layersName: string;
  readonly around: (column: string) => string;
  readonly history: CurveHistoryTexts;
  readonly surface: SurfaceTexts;
}

/** The texts of the form of a surface. */
export interface SurfaceTexts {
  readonly own: string;
  readonly name: string;
  readonly how: string;
  readonly title: string;
  readonly function: string;
  readonly language: string;
  readonly sampled: (curves: number, samples: number) => string;
  readonly give: string;
  readonly ends: Readonly<Record<'x' | 'z', readonly [string, string]>>;
  readonly curves: string;
  readonly samples: string;
  readonly tolerance: string;
  readonly toleranceHint: string;
  readonly up: string;
  readonly ways: Readonly<Record<'origin' | 'across' | 'back', string>>;
  /** The labels of x and y for a direction on the screen. */
  readonly place: readonly [string, string];
  readonly sample: (curve: number, x: number, y: number) => string;
}

/** The texts about a column and its history. */
export interface CurveHistoryTexts extends Pick<
  HistoryTexts,
  'pixel' | 'at' | 'hint' | 'how' | 'forget' | 'entries' | 'outcomes' | 'painted' | 'unpainted'
> {
  /** The horizons over a column, for its announcement: their heights, null without one. */
  readonly horizons: (upper: N | null, lower: N | null) => string;
}
