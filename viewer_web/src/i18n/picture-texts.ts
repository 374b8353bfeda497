import type { Zooming } from '../picture/frame.js';

/** What is said of the picture and of what is shown of it. */
export interface PictureTexts extends Readonly<Record<Zooming, string>> {
  readonly zoom: string;
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
  | 'chosen';
