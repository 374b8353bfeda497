import type { texts } from '../i18n/en/index.js';
import type { chart } from '../i18n/en/chart.js';
import type { LaneName } from '../strip/lanes.js';
import type { Reason, Reasons } from '../trace/refusal.js';
import type * as words from './words.js';

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

/** The page's texts in one language, except for the sentences of events, which are the library's. English has their types. */
export type Texts = typeof texts;

export type AtlasTexts = Texts['atlas'];
export type BookmarkTexts = Texts['bookmarks'];
export type CompareTexts = Texts['compare'];
export type BrokenTexts = CompareTexts['broken'];
export type CurveTexts = Texts['curves'];
export type SurfaceTexts = CurveTexts['surface'];
export type CurveHistoryTexts = CurveTexts['history'];
export type ExactTexts = Texts['exact'];
export type FamilyTexts = Texts['family'];
export type HistoryTexts = Texts['history'];
export type OutlineTexts = Texts['outline'];
export type PageTexts = Texts['page'];
export type PictureTexts = Texts['picture'];
export type PredictTexts = Texts['predict'];
export type ReaderTexts = Texts['reader'];
export type RegionTexts = Texts['regions'];
export type SceneTexts = Texts['scene'];
export type SolidTexts = Texts['solid'];
export type StripTexts = Texts['strip'];
export type ZoomTexts = StripTexts['zoom'];
export type TravelTexts = Texts['travel'];
export type WhyTexts = Texts['why'];
export type WordTexts = Texts['words'];
export type TourTexts = Texts['tour'];

/** All texts of the chart of cost against error, in one language. */
export type ChartTexts = typeof chart;
export type SubjectTexts = ChartTexts['subjects']['scenes'];

/** The texts about opening files, which both pages have. */
export type FileTexts = Pick<PageTexts & ChartTexts, keyof PageTexts & keyof ChartTexts>;

export type FailureKind = keyof AtlasTexts['kinds'];
/** The marks on the picture. */
export type LegendEntry = keyof PageTexts['legend'];
export type KeyUse = keyof PageTexts['keyMap'];
/** The runs that are offered for a comparison. */
export type Quick = keyof CompareTexts['quick'];
/** The marks on the strip. */
export type StripMark = Exclude<keyof StripTexts['explain'], LaneName>;
