/** The reasons for the colour of a pixel. */
export type Why =
  | 'hides'
  | 'centre'
  | 'alone'
  | 'nearest'
  | 'notFarther'
  | 'empty'
  | 'nothing'
  | 'beside'
  | 'region'
  | 'untouched';

export interface Reason {
  readonly why: Why;
  /** The polygon of the colour; null for the background. */
  readonly polygon: string | null;
}
