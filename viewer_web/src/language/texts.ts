import type { Outcome } from '../history/entry.js';
import type { Pixel } from '../picture/pixel.js';
import type { PixelFacts } from '../picture/pixel-facts.js';
import type { Ended } from '../replay/trace.js';
import type { LaneName } from '../strip/lanes.js';
import type { Case } from '../time/course.js';
import type { GoalName } from '../time/goals.js';
import type { Range } from '../time/range.js';
import type { NamedEdition } from '../trace/editions.js';
import type { Method } from '../trace/events.js';
import type { Reason, Reasons } from '../trace/refusal.js';
import type { Corner } from '../trace/values.js';
import type { AtlasTexts } from './atlas-texts.js';
import type { CompareTexts } from './compare-texts.js';
import type { CurveTexts } from './curve-texts.js';
import type { ExactTexts } from './exact-texts.js';
import type { FamilyTexts } from './family-texts.js';
import type { KeyTexts, KeyUse, NewsTexts } from './key-texts.js';
import type { OutlineTexts } from './outline-texts.js';
import type { LegendEntry, PictureTexts } from './picture-texts.js';
import type { PredictTexts } from './predict-texts.js';
import type { ReaderTexts } from './reader-texts.js';
import type { RegionTexts } from './region-texts.js';
import type { SceneTexts } from './scene-texts.js';
import type { SolidTexts } from './solid-texts.js';
import type * as words from './words.js';
import type { TourTexts, VerdictTexts, WordTexts } from './word-texts.js';

export type ReasonTexts = {
  readonly [K in Reason]: (...details: Reasons[K]) => string;
};

/** How numbers, and texts made from them, are written. */
export type Numbers = Pick<
  typeof words,
  | 'short'
  | 'signed'
  | 'whole'
  | 'inFull'
  | 'shortApart'
  | 'joined'
  | 'list'
  | 'point'
  | 'windowText'
>;

/** The page's texts in one language, except for the sentences of events, which are the library's. */
export interface Texts {
  readonly numbers: Numbers;
  readonly page: PageTexts;
  readonly places: Readonly<Record<Corner, string>>;
  readonly reasons: ReasonTexts;
  readonly history: HistoryTexts;
  readonly travel: TravelTexts;
  readonly strip: StripTexts;
  readonly bookmarks: BookmarkTexts;
  readonly picture: PictureTexts;
  readonly scene: SceneTexts;
  readonly exact: ExactTexts;
  readonly solid: SolidTexts;
  readonly predict: PredictTexts;
  readonly compare: CompareTexts;
  readonly reader: ReaderTexts;
  readonly family: FamilyTexts;
  readonly curves: CurveTexts;
  readonly regions: RegionTexts;
  readonly words: WordTexts;
  readonly verdict: VerdictTexts;
  readonly tour: TourTexts;
  readonly outline: OutlineTexts;
  readonly atlas: AtlasTexts;
}

/** The texts about a pixel and its history. */
export interface HistoryTexts {
  readonly pixel: string;
  readonly at: (x: number, y: number) => string;
  /** The pixel under the keyboard's cursor, for screen readers. */
  readonly spoken: (at: Pixel, facts: PixelFacts) => string;
  /** Includes the key if single-character keys are on. */
  readonly hint: (key: string | null) => string;
  readonly how: string;
  readonly forget: string;
  readonly entries: string;
  readonly outcomes: Readonly<Record<Outcome, string>>;
  readonly painted: (step: number) => string;
  readonly unpainted: string;
  readonly reading: string;
  readonly earlier: (n: number) => string;
  readonly later: (n: number) => string;
}

/** The texts about moves through a run that are longer than a step. */
export interface TravelTexts {
  readonly procedure: string;
  readonly over: string;
  readonly overBack: string;
  readonly out: string;
  readonly outBack: string;
  readonly goTo: string;
  readonly next: string;
  readonly previous: string;
  readonly goals: Readonly<Record<GoalName, string>>;
  readonly ofPolygon: string;
  readonly noGoal: string;
}

/** The texts about a place in the run, and about the strip, which shows the whole run. */
export interface StripTexts {
  readonly step: (step: number, length: number) => string;
  readonly windowAt: (size: string, at: string) => string;
  readonly polygon: (id: string) => string;
  readonly row: (row: string) => string;
  readonly bookmark: (note: string) => string;
  readonly cases: Readonly<Record<Case, string>>;
  readonly marks: Readonly<Record<'wrong' | 'fault', string>>;
  readonly lanes: Readonly<Record<LaneName, string>>;
  readonly legend: string;
  readonly explain: Readonly<Record<LaneName | StripMark, string>>;
  readonly zoom: ZoomTexts;
  readonly columns: string;
}

/** The texts about the part of a run that the strip shows. */
export interface ZoomTexts {
  readonly part: string;
  readonly shown: (range: Range, length: number) => string;
  readonly toWhole: string;
  readonly how: string;
}

/** The marks on the strip at single steps. */
export type StripMark = 'wrong' | 'fault' | 'bookmark' | 'hit' | 'now';

export interface BookmarkTexts {
  readonly title: string;
  readonly add: (step: number) => string;
  readonly edit: (step: number) => string;
  readonly placeholder: string;
  readonly goTo: (step: number) => string;
  readonly remove: (step: number) => string;
  readonly count: (n: number, most: number) => string;
  readonly full: (most: number) => string;
  readonly long: (most: number) => string;
  /** Includes the key if single-character keys are on. */
  readonly hint: (key: string | null) => string;
  readonly linked: string;
  /** The same for a page on disk, whose address works for nobody else. */
  readonly onDisk: string;
  readonly unlinked: string;
}

/** The texts of opening files. */
export interface FileTexts {
  readonly ownFile: string;
  readonly openFile: string;
  readonly dropHere: string;
}

export interface PageTexts extends FileTexts {
  readonly tagline: string;
  readonly lessons: string;
  readonly noLessons: string;
  readonly reading: (name: string) => string;
  readonly growing: (steps: string, percent: number) => string;
  readonly stopReading: string;
  readonly unreadable: (name: string, line: number, where: string, reason: string) => string;
  readonly unknown: (name: string) => string;
  /** A link that could not hold what it was made from. */
  readonly unheld: string;
  /** The run lost something at these many steps, first at this one. */
  readonly lost: (faults: number, step: string) => string;
  readonly goToLoss: (step: string) => string;
  readonly broken: (name: string) => string;
  readonly refusedScene: (name: string, why: string) => string;
  /** The same before a list of errors. */
  readonly refusedFor: (name: string) => string;
  readonly isChart: (name: string) => string;
  readonly isMesh: (name: string) => string;
  readonly noWebAssembly: string;
  readonly emptyFile: (name: string) => string;
  readonly shortened: Readonly<Record<Ended['why'], (line: number) => string>>;
  readonly wrongLine: (line: number, where: string, reason: string) => string;
  readonly methods: Readonly<Record<Method, string>>;
  readonly editions: Readonly<Record<NamedEdition, string>>;
  /** The decisions of a run were compared with exact arithmetic. */
  readonly checked: string;
  readonly kernel: string;
  readonly detail: string;
  readonly start: string;
  readonly unnamed: string;
  readonly nothingOpen: string;
  readonly picture: string;
  readonly savePicture: (kind: string) => string;
  readonly listing: string;
  readonly source: string;
  readonly things: ThingTexts;
  readonly callStack: string;
  readonly state: string;
  readonly first: string;
  readonly back: string;
  readonly forward: string;
  readonly last: string;
  readonly play: string;
  readonly playAgain: string;
  readonly pause: string;
  readonly step: string;
  readonly ofSteps: (length: string) => string;
  readonly speed: string;
  readonly perSecond: (n: number) => string;
  /** The same, abbreviated. */
  readonly rate: (n: number) => string;
  readonly keys: string;
  readonly close: string;
  readonly skip: string;
  /** The view with everything known about a step. */
  readonly workbench: string;
  readonly workbenchHint: string;
  /** The label of the button that shows the tools where there is no room for them. */
  readonly tools: string;
  /** A line between two panels, which may be dragged. */
  /** The dividers, by the part whose size they change. */
  readonly sizeOf: Readonly<Record<'text' | 'picture' | 'listing' | 'scene', string>>;
  readonly news: NewsTexts;
  readonly present: string;
  readonly leave: string;
  readonly keyMap: Readonly<Record<KeyUse, string>>;
  readonly ownKeys: KeyTexts;
  readonly window: string;
  readonly none: string;
  readonly legend: Readonly<Record<LegendEntry, string>>;
  readonly cornerDepths: string;
  readonly apl: string;
  readonly surrounds: string;
  readonly stack: string;
  readonly empty: string;
  readonly clip: string;
  readonly ael: string;
  readonly edge: string;
  readonly until: string;
  readonly unsorted: string;
  readonly depths: string;
  readonly row: string;
  readonly yes: string;
  readonly no: string;
  readonly more: (n: number) => string;
  readonly notInTrace: string;
  readonly depthsTooMany: string;
  readonly defect: (id: string) => string;
}

/** The names of things that can be pointed at. */
export interface ThingTexts {
  readonly polygon: (id: string) => string;
  readonly edge: (edge: number) => string;
  readonly corner: (place: string) => string;
  readonly window: (window: string) => string;
}
