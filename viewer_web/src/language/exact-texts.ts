import type { Column } from '../exactness/calculation.js';
import type { Coincidence, FindingKind, Order } from '../exactness/finding.js';
import type { WindowCorner, WindowSide } from '../exactness/margin.js';
import type { Cell } from '../exactness/sign-map.js';
import type { Unable } from '../exactness/truth.js';
import type { Stage } from '../exactness/verdict.js';
import type { Decision, Event } from '../trace/events.js';
import type { Answer } from '../trace/values.js';

/** The texts about a decision and the right answer. */
export interface ExactTexts {
  readonly exactness: string;
  /** Used in the middle of a sentence. */
  readonly decided: Readonly<Record<Decision, string>>;
  readonly causes: Readonly<Record<Event<'disagree'>['cause'], string>>;
  readonly answer: (answer: Answer) => string;
  readonly computed: string;
  readonly exact: string;
  readonly decidedBy: string;
  readonly stages: Readonly<Record<Stage, string>>;
  readonly right: string;
  readonly wrong: string;
  readonly undefined: string;
  readonly unchecked: string;
  /** Shown in place of the number of wrong decisions. */
  readonly notChecked: string;
  readonly checking: string;
  /** Shown in place of the number of wrong decisions during the check. */
  readonly checkingShort: string;
  readonly found: (wrong: number) => string;
  /** No decision is wrong, but the text is not the corrected one. */
  readonly foundNoneBut: string;
  readonly unable: Readonly<Record<Unable, string>>;
  readonly certain: string;
  readonly check: string;
  /** The list of decisions worth looking at. */
  readonly findings: {
    readonly title: string;
    readonly count: (count: number) => string;
    readonly withNumbers: string;
    readonly more: string;
    readonly polygons: string;
    readonly columns: Readonly<Record<Order, string>>;
    readonly kinds: Readonly<Record<FindingKind, string>>;
    readonly coincidences: Readonly<Record<Coincidence, string>>;
    readonly pixels: (off: string) => string;
    /** The difference between two numbers. */
    readonly gap: (computed: string, exact: string) => string;
    readonly decides: (pixels: string) => string;
  };
  /** The effect of moving a vertex across a side of its margin. */
  readonly margin: {
    readonly edge: (edge: number, at: string) => string;
    readonly vertex: (side: WindowSide) => string;
    readonly edgeAtCorner: (edge: number, corner: WindowCorner) => string;
  };
  /** The heading of the calculation line by line, and its two versions. */
  readonly byHand: string;
  readonly byHandWith: Readonly<Record<Column, string>>;
  readonly noNumbers: string;
  readonly nothing: string;
  readonly findWrong: string;
  readonly lens: (at: string) => string;
  readonly apart: (ulp: string) => string;
  readonly noLens: string;
  readonly drawing: string;
  readonly wrongPlaces: (wrong: number, all: number) => string;
  readonly drifted: string;
  /** The signs at a place the given number of ulps away. */
  readonly cell: (x: number, y: number, computed: string, exact: string) => string;
  readonly signs: Readonly<Record<`${Cell['exact']}`, string>>;
  readonly yesNo: Readonly<Record<`${Cell['exact']}`, string>>;
  readonly pale: string;
  readonly dark: string;
}
