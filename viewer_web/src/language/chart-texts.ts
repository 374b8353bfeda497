import type { Operation, Sampling } from '../chart/advice.js';
import type { Cost, ErrorMeasure, Kind, Knob } from '../chart/format.js';
import type { Unlinked } from '../chart/replay.js';
import type { Method } from '../chart/scene-format.js';
import type { Setting } from '../chart/series.js';
import type { Distance } from '../chart/subject.js';
import type { FamilyTexts } from './family-texts.js';
import type { FileTexts } from './texts.js';

export interface CostTexts {
  readonly name: string;
  /** The label of the axis, for a single subject and for means. */
  readonly axis: string;
  readonly ratioAxis: string;
  readonly sentence: (rounds: string) => string;
  readonly ratioSentence: string;
}

export interface ErrorTexts {
  readonly name: string;
  readonly axis: string;
  readonly sentence: string;
  readonly meanSentence: string;
}

/** The links from a run to its replay. */
export interface ReplayTexts {
  readonly title: string;
  readonly hint: string;
  readonly replay: string;
  readonly compare: string;
  readonly unlinked: Readonly<Record<Unlinked, string>>;
}

/** Which run is needed, and why. */
export interface AdviceTexts {
  readonly none: string;
  readonly cheapest: (run: string, cost: string, amount: string) => string;
  readonly cheaper: (count: string, leastWrong: string, share: string) => string;
  readonly safe: string;
  readonly safer: (run: string, times: string) => string;
  readonly others: (runs: string) => string;
  readonly neverRight: (means: string) => string;
}

/** The errors of a surface between the samples, and by arithmetic. */
export interface LossTexts {
  readonly nothing: string;
  readonly height: (pixels: string) => string;
  readonly noDecision: string;
  readonly decisions: (kernels: string) => string;
}

/** The texts that differ between the chart of scenes and that of surfaces. */
export interface SubjectTexts {
  readonly show: string;
  readonly showOne: string;
  /** The name of a series without a knob. */
  readonly fixed: string;
  readonly missingSomewhere: (runs: string) => string;
  readonly advice: AdviceTexts;
}

/** All texts of the chart of cost against error, in one language. */
export interface ChartTexts extends FileTexts {
  readonly tagline: string;
  readonly subjects: Readonly<Record<'scenes' | 'surfaces', SubjectTexts>>;
  readonly kinds: Readonly<Record<Kind, string>>;
  readonly allOf: Readonly<Record<Kind, (count: string) => string>>;
  readonly aboutScene: (pixels: string, polygons: string, unsteady: string) => string;
  readonly aboutSurface: (curves: string, columns: string) => string;
  readonly cost: string;
  readonly error: string;
  readonly series: string;
  readonly methods: Readonly<Record<Method, string>>;
  /** Warnock's algorithm. */
  readonly variants: string;
  readonly variantNames: FamilyTexts['names'];
  readonly knobs: Readonly<Record<Knob, string>>;
  readonly turned: Readonly<Record<Knob, (value: string) => string>>;
  /** How a surface's curves may be sampled. */
  readonly samplings: Readonly<Record<Sampling, string>>;
  readonly editions: Readonly<Record<Setting['edition'], string>>;
  readonly fault: string;
  readonly printed: string;
  readonly printedLabel: (kernel: string) => string;
  readonly costs: Readonly<Record<Cost, CostTexts>>;
  readonly errors: Readonly<Record<ErrorMeasure, ErrorTexts>>;
  readonly counted: (part: string, all: string) => string;
  readonly units: Readonly<Record<Distance, (count: string) => string>>;
  readonly reading: string;
  readonly missing: (kernels: string) => string;
  readonly rightPicture: (share: string) => string;
  readonly plot: (cost: string, error: string) => string;
  readonly keys: string;
  readonly front: string;
  readonly frontMark: string;
  readonly run: string;
  readonly whichRun: string;
  readonly losses: LossTexts;
  readonly operations: Readonly<Record<Operation, (share: string) => string>>;
  readonly replay: ReplayTexts;
  readonly empty: string;
  readonly howTo: string;
  readonly unreadable: (name: string, where: string, reason: string) => string;
  readonly broken: (name: string) => string;
}
