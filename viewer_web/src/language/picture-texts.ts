import type { Zooming } from '../picture/frame.js';
import type { Layer } from '../picture/layers.js';

/** The texts about the picture and its layers. */
export interface PictureTexts extends Readonly<Record<Zooming, string>> {
  readonly zoom: string;
  readonly legend: string;
  readonly readout: Readonly<Record<'unpainted' | 'background' | 'or', string>>;
  readonly layer: string;
  readonly layers: Readonly<Record<Layer, string>>;
  readonly soFar: string;
  readonly exactly: string;
  readonly computing: string;
  readonly ramp: string;
  readonly fromTo: (far: string, near: string) => string;
  readonly wrong: (n: number) => string;
  readonly lacking: (n: number) => string;
}

/** The marks on the picture that the legend explains. */
export type LegendEntry =
  | 'window'
  | 'way'
  | 'tree'
  | 'stacked'
  | 'active'
  | 'touched'
  | 'yes'
  | 'no'
  | 'scanline'
  | 'edge'
  | 'chosen'
  | CurveLegendEntry
  | RegionLegendEntry;

/** The marks on the picture of curves. */
export type CurveLegendEntry =
  'visible' | 'inHand' | 'upper' | 'lower' | 'above' | 'below' | 'hidden' | 'sideEdge';

/** The marks on the picture of regions. */
export type RegionLegendEntry =
  | 'clipRegion'
  | 'subject'
  | 'insidePart'
  | 'outsidePart'
  | 'enters'
  | 'leaves'
  | 'shown'
  | 'piercing';
