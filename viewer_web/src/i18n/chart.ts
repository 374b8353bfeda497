import type { Operation } from '../chart/advice.js';
import type { Cost, ErrorMeasure, Kind, Knob, Method } from '../chart/format.js';
import type { Unlinked } from '../chart/replay.js';
import type { Setting } from '../chart/series.js';
import type { Refusal } from '../trace/refusal.js';
import { chart as en } from './en/chart.js';
import { reasons as enReasons } from './en/reasons.js';
import type { Language } from './language.js';
import { chart as ru } from './ru/chart.js';
import { reasons as ruReasons } from './ru/reasons.js';
import type { FamilyTexts } from './family-texts.js';
import type { FileTexts, ReasonTexts } from './texts.js';

export interface CostTexts {
  readonly name: string;
  /** The axis, of a single scene and of means. */
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

/** The ways from a run to its replay. */
export interface ReplayTexts {
  readonly title: string;
  readonly hint: string;
  readonly oneScene: string;
  readonly replay: string;
  readonly compare: string;
  readonly unlinked: Readonly<Record<Unlinked, string>>;
}

/** Which run is needed, and why. */
export interface AdviceTexts {
  readonly title: string;
  readonly none: string;
  readonly cheapest: (run: string, cost: string, amount: string) => string;
  readonly cheaper: (count: string, leastWrong: string, share: string) => string;
  readonly safe: string;
  readonly safer: (run: string, times: string) => string;
  readonly others: (runs: string) => string;
  readonly neverRight: (methods: string) => string;
}

/** Everything that the page of cost against error says, in one language. */
export interface ChartTexts extends FileTexts {
  readonly tagline: string;
  readonly show: string;
  readonly kinds: Readonly<Record<Kind, string>>;
  readonly allOf: Readonly<Record<Kind, (count: string) => string>>;
  readonly aboutScene: (pixels: string, polygons: string, unsteady: string) => string;
  readonly cost: string;
  readonly error: string;
  readonly series: string;
  readonly methods: Readonly<Record<Method, string>>;
  /** Of Warnock's algorithm. */
  readonly variants: string;
  readonly variantNames: FamilyTexts['names'];
  readonly knobs: Readonly<Record<Knob, string>>;
  readonly turned: Readonly<Record<Knob, (value: string) => string>>;
  readonly fixed: string;
  readonly editions: Readonly<Record<Setting['edition'], string>>;
  readonly fault: string;
  readonly printed: string;
  readonly printedLabel: (kernel: string) => string;
  readonly costs: Readonly<Record<Cost, CostTexts>>;
  readonly errors: Readonly<Record<ErrorMeasure, ErrorTexts>>;
  readonly counted: (part: string, all: string) => string;
  readonly ulps: (count: string) => string;
  readonly reading: string;
  readonly missing: (kernels: string) => string;
  readonly missingSomewhere: (kernels: string) => string;
  readonly rightPicture: (share: string) => string;
  readonly plot: (cost: string, error: string) => string;
  readonly keys: string;
  readonly front: string;
  readonly frontMark: string;
  readonly run: string;
  readonly advice: AdviceTexts;
  readonly operations: Readonly<Record<Operation, (share: string) => string>>;
  readonly replay: ReplayTexts;
  readonly empty: string;
  readonly howTo: string;
  readonly unreadable: (name: string, where: string, reason: string) => string;
  readonly broken: (name: string) => string;
}

export const chartTexts: Readonly<Record<Language, ChartTexts>> = { en, ru };

const reasons: Readonly<Record<Language, ReasonTexts>> = { en: enReasons, ru: ruReasons };

/** What is wrong with a file: place and reason. */
export function chartComplaint(
  name: string,
  { path, reason, details }: Refusal,
  language: Language,
): string {
  const say: (...details: string[]) => string = reasons[language][reason];
  return chartTexts[language].unreadable(name, path, say(...details));
}
