import type { Counter } from '../compare/counters.js';

/** The texts of a comparison of two runs. */
export interface CompareTexts {
  readonly compare: string;
  readonly compareWith: string;
  readonly leave: string;
  readonly cancel: string;
  readonly sameScene: string;
  readonly quick: Readonly<Record<Quick, string>>;
  readonly run: string;
  readonly noLibrary: string;
  readonly otherTrace: string;
  readonly ofLessons: string;
  readonly open: string;
  readonly thisRun: string;
  readonly otherRun: string;
  readonly before: string;
  readonly step: (step: string, length: string) => string;
  readonly otherStep: string;
  readonly back: string;
  readonly forward: string;
  readonly together: string;
  readonly togetherHint: string;
  readonly byShare: string;
  readonly byShareAfter: string;
  readonly parting: string;
  readonly text: string;
  readonly deed: string;
  readonly atStep: (step: string) => string;
  readonly nowhere: string;
  readonly searching: string;
  readonly otherMethods: string;
  readonly differ: string;
  readonly differColumns: string;
  readonly differNow: (n: string) => string;
  readonly differAtEnd: (n: string) => string;
  readonly otherArea: string;
  readonly otherColor: string;
  readonly unpainted: string;
  readonly mark: string;
  readonly edit: string;
  readonly editHint: string;
  readonly counters: string;
  readonly soFar: string;
  readonly inAll: string;
  readonly counts: Readonly<Record<Counter, string>>;
  readonly broken: BrokenTexts;
}

/** The texts about a broken line of a procedure. */
export interface BrokenTexts {
  readonly offer: string;
  readonly explained: string;
  readonly offerAt: (line: string) => string;
  readonly printed: string;
  readonly mistake: string;
  readonly is: (lines: string) => string;
  readonly first: (step: string) => string;
  readonly pixels: (n: string, all: string) => string;
  readonly columns: (n: string) => string;
  readonly fault: (step: string) => string;
  readonly stepsAlone: string;
  readonly nothing: string;
  readonly smallest: string;
  readonly isSmallest: (name: string) => string;
  readonly own: string;
  readonly back: string;
  readonly right: string;
  readonly wrong: string;
}

/** What a run can be compared with at one click. */
export type Quick = 'method' | 'variant' | 'printed' | 'corrected' | 'exact' | 'float' | 'before';
