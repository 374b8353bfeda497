/** The ways in which a pixel comes by its colour. */
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
  /** Whose colour it is; none for the background. */
  readonly polygon: string | null;
}
