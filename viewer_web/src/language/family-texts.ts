import type { Method, Procedure } from '../trace/events.js';

type Variant = Exclude<Method, 'warnock' | 'zbuffer' | 'floating-horizon' | 'weiler-atherton'>;
type OfVariants = 'Relation' | 'TrialFunction' | 'RayCrossings' | 'OctantAngles' | 'HidingPolygon';

type Names = Readonly<Record<Variant, string>>;

/** The names of variants with that of the algorithm before them. */
export function prefixed(before: string, names: Names): Names {
  return Object.fromEntries(
    Object.entries(names).map(([variant, name]) => [variant, before + name]),
  ) as Names;
}

/** What is said of the variants of Warnock's algorithm alone. */
export interface FamilyTexts {
  /** Among one another, and among other methods. */
  readonly names: Names;
  readonly methods: Names;
  /** What each method takes and does. */
  readonly rules: Readonly<Record<Method, string>>;
  readonly purposes: Readonly<Record<OfVariants & Procedure, string>>;
  readonly panel: FamilyPanelTexts;
}

/** What stands in the panel of the state. */
export interface FamilyPanelTexts {
  readonly level: string;
  readonly third: string;
  readonly surrounding: string;
  readonly outside: string;
  readonly sinceLevel: (level: number) => string;
  readonly hides: string;
  readonly ray: string;
  readonly octants: string;
}
