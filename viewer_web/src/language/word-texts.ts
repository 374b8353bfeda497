import type { Detail } from '../trace/events.js';

/** Explanations of the words that name runs. */
export interface WordTexts {
  readonly explain: string;
  readonly editions: Readonly<Record<'corrected' | 'printed' | 'defects' | 'mistake', string>>;
  readonly details: Readonly<Record<Detail, string>>;
}

/** The texts at the end of a run. */
export interface VerdictTexts {
  readonly pixels: (n: number) => string;
  readonly allRight: string;
  /** The same where polygons share a colour, so that a right colour may be that of a wrong polygon. */
  readonly allColorsRight: string;
  readonly someWrong: (n: number) => string;
  /** The same for a text that is not the corrected one: its arithmetic may be right. */
  readonly someOther: (n: number) => string;
  readonly comparing: string;
  readonly notCompared: string;
  readonly decisionsRight: string;
  /** The same for a text that is not the corrected one: its picture may be wrong nevertheless. */
  readonly decisionsRightBut: string;
  /** The number of steps. */
  readonly decisionsWrong: (n: number) => string;
  readonly windows: (n: number) => string;
  readonly comparisons: (n: number) => string;
  readonly regions: (n: number) => string;
  readonly curves: (n: number) => string;
}

/** A tour of a few steps through the page. */
export interface TourTexts {
  /** What the page does, for a first visitor. */
  readonly about: string;
  readonly offer: string;
  readonly again: string;
  readonly next: string;
  readonly done: string;
  readonly leave: string;
  readonly at: (n: number, of: number) => string;
  readonly steps: readonly { readonly title: string; readonly text: string }[];
}
