import type { Counter } from '../compare/counters.js';
import type { Sum } from '../compare/survey.js';
import type { Abouts } from '../exactness/mapped-decision.js';
import type { Entry, Watch } from '../history/entry.js';
import type { Reason } from '../history/why.js';
import type { SolidTexts } from '../language/solid-texts.js';
import type { HistoryTexts, SentencesOf } from '../language/texts.js';
import type { Known } from '../language/words.js';
import type { Notes } from '../listing/notes.js';
import type { Outlined } from '../outline/outlined.js';
import type { Mark } from '../picture/mark.js';
import type { Pixel } from '../picture/pixel.js';
import type { Askers } from '../predict/asker.js';
import type { Fact } from '../predict/facts.js';
import type { Sight } from '../replay/quadtree.js';
import type { Drawing } from '../solid/drawing.js';
import type { Space } from '../solid/space.js';
import type { Lanes } from '../strip/lanes.js';
import type { Book, Watched } from '../time/course.js';
import type { OwnGoal } from '../time/goals.js';
import type { Event, EventName, Method } from '../trace/events.js';
import type { Header } from '../trace/header.js';
import type { Box } from '../trace/values.js';
import type { Thing } from './pointed.js';
import type { View } from './view.js';

/**
 * All that the page says and shows of the runs of one algorithm, but for its elements: see `Shows`. What its runs hold is its
 * `Model`. Warnock's algorithm has several methods, its variants; each of the others has one.
 */
export interface Algorithm {
  /** The sentences of the events that it alone tells, and of others where it says more. */
  readonly sentences: Partial<SentencesOf<EventName>>;
  /** What its events say beside their lines of the listing. */
  readonly notes: Partial<Notes>;
  /** The events that make another window, polygon, curve or list the current item. */
  readonly begins: readonly EventName[];

  /** What can be pointed at in a step, beside the polygons. */
  things(view: View): readonly string[];
  /** What stands on the picture because of the state, and of the step itself. */
  marks(view: View, sight: Sight): readonly Mark[];
  /** How a thing that is pointed at is marked. */
  thingMarks?(thing: Thing, view: View): readonly Mark[];
  /** The picture of a step as an SVG document of its own. */
  figure(view: View): string;
  /** What a step adds to the scene in space, and how it is said; none where the scene has no polygons. */
  readonly solid?: {
    drawing(view: View, space: Space): Partial<Drawing>;
    pointed?(thing: Thing, view: View, space: Space): Partial<Drawing>;
    caption(view: View, texts: SolidTexts): readonly string[];
  };

  /** What the strip shows of a run, and how the course learns of the steps that change the current item. */
  readonly lanes: Lanes;
  course(book: Book): Watched;
  /** What its outline has beside that. */
  readonly outline: Outlined;
  /** What one may go to, beside wrong decisions, the chosen pixel and bookmarks. */
  readonly goals: readonly OwnGoal[];

  /** Follows a pixel, or a column, through a run. */
  watch(pixel: Pixel, header: Header): Watch;
  /** The item that was current at an entry of a pixel's history. */
  heading(known: Known, event: Event): Heading | null;
  /** Why the entry that painted the pixel gave it its colour. */
  why?(entry: Entry, header: Header): Reason;
  /** What is said of an entry in place of its step's sentence; null where nothing is. */
  entry?(entry: Entry, texts: HistoryTexts): string | null;

  /** What is asked in exact arithmetic, and at the points around, of its decisions about points. */
  readonly abouts: Abouts;

  readonly askers: Askers;
  /** What must be known at a step to answer a question. */
  facts(view: View): readonly Fact[];
  /** The polygons that a question is about, which names one itself or none. */
  polygonsAsked(view: View, named: string | null): readonly string[];

  /** What is counted of a run by the names of its events. */
  readonly counts: Readonly<Partial<Record<Counter, readonly EventName[]>>>;
  /** What is counted otherwise. */
  readonly sums: readonly Sum[];
  /** The events that a run has at most once with the current item: by these steps runs are paired. */
  readonly landmarks: readonly EventName[];
  landmark(event: Event, inHand: string): string | null;
}

/** A window, a polygon, or a curve. */
export type Heading = Box | string | number;

const algorithms = new Map<Method, Algorithm>();

/** Makes an algorithm known; each does so once, as the page is loaded. */
export function defineAlgorithm(methods: readonly Method[], algorithm: Algorithm): void {
  for (const method of methods) algorithms.set(method, algorithm);
}

export function algorithmOf({ method }: { readonly method: Method }): Algorithm {
  const algorithm = algorithms.get(method);
  if (algorithm === undefined) throw new Error(`the algorithm of ${method} was not defined`);
  return algorithm;
}
