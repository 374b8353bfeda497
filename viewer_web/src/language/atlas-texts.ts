/** The cause of a failure in the atlas. */
export type FailureKind = 'rounding' | 'printed' | 'mistake' | 'limit' | 'test';

/** The texts of the atlas of failures. */
export interface AtlasTexts {
  readonly title: string;
  /** The label of the button that opens it. */
  readonly open: string;
  readonly close: string;
  readonly show: string;
  readonly all: string;
  readonly kinds: Readonly<Record<FailureKind, string>>;
  /** Instead of a picture. */
  readonly noScene: string;
  readonly remedy: string;
  /** The step at which a failure shows, and the defect there. */
  readonly at: (step: string, there: string) => string;
  readonly goTo: string;
  readonly compare: string;
  readonly leave: string;
  /** The panel of the open failure. */
  readonly forget: string;
}
