import type { Texts } from '../language/texts.js';
import type { Mark } from '../picture/mark.js';
import type { Box, Corner, N, Point } from '../trace/values.js';

/** The kinds of questions, in the order of the reader's choice. */
export const kinds = [
  'plane',
  'facing',
  'window',
  'pop',
  'split',
  'relation',
  'trial',
  'ray',
  'octants',
  'corners',
  'depth',
  'edgeDepth',
  'inside',
  'point',
  'clip',
  'fill',
  'ael',
  'pixels',
  'flags',
  'horizons',
  'sideEdge',
  'meeting',
  'piercing',
  'sort',
  'parted',
  'entering',
  'walk',
  'behind',
  'stack',
  'painted',
] as const;
export type Kind = (typeof kinds)[number];

/** The procedures that answer a question of a kind. */
export const proceduresOf: Readonly<Record<Kind, readonly string[]>> = {
  plane: ['InitializePolygon'],
  facing: ['BackFaces'],
  window: ['ProcessWindow', 'SimplestWarnock', 'ThreeListsWarnock'],
  pop: ['Warnock', 'SimplestWarnock', 'ThreeListsWarnock'],
  split: ['VertexSplit'],
  relation: ['Relation'],
  trial: ['TrialFunction'],
  ray: ['RayCrossings'],
  octants: ['OctantAngles'],
  corners: ['ProcessWindow', 'HidingPolygon'],
  depth: ['Depth'],
  edgeDepth: ['EdgeDepth'],
  inside: ['SurroundTest'],
  point: ['PointColor'],
  clip: ['PolygonClip'],
  fill: ['FillPolygon'],
  ael: ['ZBuffer'],
  pixels: ['ShowLine'],
  flags: ['Visibility'],
  horizons: ['Horizon'],
  sideEdge: ['SideEdge'],
  meeting: ['Intersection'],
  piercing: ['SplitPiercing'],
  sort: ['DepthSort'],
  parted: ['WeilerAtherton'],
  entering: ['RegionClip'],
  walk: ['RegionClip'],
  behind: ['RemoveBehind'],
  stack: ['WeilerAtherton'],
  painted: ['PaintRegions'],
};

/** How a part is answered: by one of its options, by any set of them, by a typed row of them, or by a table of numbers. */
export type Form = 'one' | 'some' | 'row' | 'table';

/** The type of a part's options, which determines how they are shown. */
export type Of =
  | 'case'
  | 'polygon'
  | 'window'
  | 'corner'
  | 'relation'
  | 'yes'
  | 'lies'
  | 'test'
  | 'number'
  | 'sign'
  | 'vertex'
  | 'point'
  | 'edge'
  | 'segment'
  | 'depth'
  | 'column'
  | 'horizon'
  | 'spot'
  | 'next';

/** The parts that questions have, and how each is answered. */
export const parts = {
  plane: ['table', 'number'],
  away: ['some', 'polygon'],
  boundaries: ['table', 'number'],
  splits: ['one', 'yes'],
  cornerSigns: ['row', 'sign'],
  meetsFirst: ['one', 'edge'],
  z: ['table', 'number'],
  bothDepths: ['table', 'number'],
  nearerThere: ['one', 'relation'],
  spanning: ['some', 'edge'],
  covered: ['some', 'column'],
  popped: ['one', 'window'],
  waiting: ['one', 'number'],
  case: ['one', 'case'],
  stay: ['some', 'polygon'],
  hides: ['one', 'polygon'],
  nearer: ['some', 'corner'],
  cornerDepths: ['one', 'relation'],
  inside: ['one', 'yes'],
  signs: ['row', 'sign'],
  covers: ['some', 'polygon'],
  wins: ['one', 'polygon'],
  depth: ['one', 'depth'],
  cut: ['some', 'segment'],
  list: ['row', 'vertex'],
  leave: ['some', 'edge'],
  enter: ['some', 'edge'],
  order: ['row', 'edge'],
  entries: ['table', 'number'],
  shown: ['some', 'column'],
  pixelDepths: ['one', 'relation'],
  lies: ['one', 'lies'],
  test: ['one', 'test'],
  crossed: ['some', 'edge'],
  crossings: ['one', 'number'],
  halved: ['some', 'edge'],
  sum: ['one', 'number'],
  above: ['some', 'column'],
  below: ['some', 'column'],
  raised: ['some', 'column'],
  lowered: ['some', 'column'],
  meets: ['one', 'horizon'],
  where: ['one', 'spot'],
  pierced: ['some', 'polygon'],
  pieces: ['one', 'number'],
  first: ['one', 'polygon'],
  within: ['some', 'polygon'],
  beyond: ['some', 'polygon'],
  outlines: ['one', 'number'],
  enters: ['some', 'point'],
  leaves: ['some', 'point'],
  walked: ['row', 'vertex'],
  hidden: ['some', 'polygon'],
  partDepth: ['one', 'relation'],
  next: ['one', 'next'],
  clips: ['one', 'polygon'],
  listed: ['some', 'polygon'],
} as const satisfies Readonly<Record<string, readonly [Form, Of]>>;
export type Asks = keyof typeof parts;

/** A fact about an option that helps to answer, as text in a language. */
export type Note = (texts: Pick<Texts, 'numbers' | 'curves'>) => string;

export interface Option {
  readonly value: string;
  readonly note?: Note;
  /** Where it can be chosen in the picture, if its type does not say that. */
  readonly places?: readonly Mark[];
}

/** The columns of each table to be filled in. An active edge has its x on the scanline and its last row. */
const tables = {
  plane: ['a', 'b', 'd'],
  boundaries: ['column', 'row'],
  z: ['z'],
  bothDepths: ['z', 'otherZ'],
  entries: ['x', 'until'],
} as const satisfies Partial<Readonly<Record<Asks, readonly string[]>>>;
export type Column = (typeof tables)[keyof typeof tables][number];

/** The columns of a part's table; none if its answer is no table. */
export const columnsOf = ({ asks }: Pick<Part, 'asks'>): readonly Column[] =>
  asks in tables ? tables[asks as keyof typeof tables] : [];

/** Denotes, in a list of vertices, one that a crossing makes. */
export const crossing = 'x';

/** Denotes the place between two columns, among options that are columns. */
export const between = 'between';

/** The possible relations of a polygon to a window. */
export const relations = ['outside', 'inside', 'intersecting', 'surrounding'] as const;
/** The possible deciding lines, in the order of the listing: either line about the box, the edges, or containment. */
export const tests = ['RE1', 'RE2', 'RE3', 'RE4'] as const;
/** The possible results for a region that nothing hides. */
export const becomes = ['visible', 'again'] as const;
export type Becomes = (typeof becomes)[number];

/** Denotes no polygon, among options that are polygons. */
export const none = '';

/** The subject of a part, if it differs from the options. */
export interface Given extends Option {
  readonly of: Of;
}

/** One thing that a question asks. An answer is a list of option values; for a table, of the numbers in its cells, row by row. */
export interface Part {
  readonly asks: Asks;
  readonly options: readonly Option[];
  readonly right: readonly string[];
  readonly given?: readonly Given[];
  /** The step that decides an option, an entry of a row, or a cell; without it, the last step that decides the question. */
  decidedBy?(value: string | null, at: number): number | undefined;
}

/** The data that the text of a question names. */
export interface Abouts {
  /** With the coefficient c of its plane. */
  readonly plane: { readonly polygon: string; readonly c: N };
  readonly facing: object;
  /** The number of the vertex, from 0. */
  readonly split: { readonly polygon: string; readonly vertex: number; readonly window: Box };
  readonly trial: { readonly polygon: string; readonly edge: number; readonly window: Box };
  readonly depth: { readonly polygon: string; readonly point: Point; readonly plane: readonly N[] };
  readonly edgeDepth: { readonly polygon: string; readonly point: Point };
  /** The outline that is filled. */
  readonly fill: {
    readonly polygon: string;
    readonly row: number;
    readonly outline: readonly (readonly N[])[];
  };
  /** With the procedure that looks for a polygon that hides all others. */
  readonly window: {
    readonly window: Box;
    readonly by: 'ProcessWindow' | 'HidingPolygon' | null;
  };
  /** The window that was divided. */
  readonly pop: { readonly divided: Box };
  readonly relation: { readonly polygon: string; readonly window: Box };
  readonly ray: { readonly polygon: string; readonly window: Box };
  readonly octants: { readonly polygon: string; readonly window: Box };
  readonly corners: { readonly polygon: string };
  readonly inside: {
    readonly polygon: string;
    readonly point: Point;
    readonly corner: Corner | null;
  };
  readonly point: { readonly point: Point };
  readonly clip: { readonly polygon: string; readonly side: number };
  /** The current scanline; null before the first one. */
  readonly ael: { readonly polygon: string; readonly row: number | null };
  readonly pixels: { readonly polygon: string; readonly row: number };
  readonly flags: { readonly curve: number };
  readonly horizons: { readonly curve: number };
  readonly meeting: { readonly curve: number };
  /** The ends of the edge: a sample of an earlier curve, and one of this curve. */
  readonly sideEdge: {
    readonly curve: number;
    readonly from: readonly N[];
    readonly to: readonly N[];
  };
  readonly painted: { readonly polygon: string; readonly other: string; readonly point: Point };
  readonly piercing: { readonly polygons: readonly string[] };
  readonly sort: { readonly pieces: number };
  readonly parted: { readonly clip: string; readonly pieces: number };
  readonly entering: { readonly polygon: string; readonly clip: string };
  /** The number of the point at which the walk begins. */
  readonly walk: { readonly polygon: string; readonly clip: string; readonly from: string };
  readonly behind: { readonly clip: string };
  readonly stack: { readonly clip: string; readonly nearer: readonly string[] };
}

interface Asked<K extends Kind> {
  readonly kind: K;
  /** The step at which it is asked: everything needed for the answer has happened. */
  readonly step: number;
  /** The step by which the run has answered it. */
  readonly until: number;
  readonly about: Abouts[K];
  readonly parts: readonly Part[];
  /** The steps that decide it. */
  readonly because: readonly number[];
  /** The things that it is about, which can be pointed at. */
  readonly things: readonly string[];
}

/** A question that the run itself answers in its next steps. */
export type Question<K extends Kind = Kind> = { readonly [P in K]: Asked<P> }[K];
