import type { Counter } from '../compare/counters.js';
import type { Sum } from '../compare/survey.js';
import type { Abouts } from '../exactness/mapped-decision.js';
import type { SolidTexts } from '../language/texts.js';
import type { Outlined } from '../outline/outlined.js';
import type { Mark } from '../picture/mark.js';
import type { Askers } from '../predict/asker.js';
import type { Fact } from '../predict/facts.js';
import type { Sight } from '../replay/screen.js';
import type { Values } from '../replay/values.js';
import type { Drawing } from '../solid/drawing.js';
import type { Space } from '../solid/space.js';
import type { Lanes } from '../strip/lanes.js';
import type { Book, Watched } from '../time/course.js';
import type { OwnGoal } from '../time/goals.js';
import type { Event, EventName, Method } from '../trace/events.js';
import type { Header } from '../trace/header.js';
import type { Owners } from './owners.js';
import type { Thing } from './pointed.js';
import type { View } from './view.js';

/**
 * Everything that the page says and shows about the runs of one algorithm, except its elements (see `Shows`). The content
 * of its runs is its `Model`. Warnock's algorithm has several methods, its variants; each of the others has one.
 */
export interface Algorithm {
  /** The events that make another window, polygon, curve or list the current item. */
  readonly begins: readonly EventName[];

  /** What can be pointed at in a step, besides the polygons. */
  things(view: View): readonly string[];
  /** The marks on the picture that show the state and the step itself. */
  marks(view: View, sight: Sight): readonly Mark[];
  /** The marks of a thing that is pointed at. */
  thingMarks?(thing: Thing, view: View): readonly Mark[];
  /** The picture of a step as a separate SVG document. */
  figure(view: View): string;
  /** The additions of a step to the 3D scene, and their caption. Undefined for scenes without polygons. */
  readonly solid?: {
    drawing(view: View, space: Space): Partial<Drawing>;
    pointed?(thing: Thing, view: View, space: Space): Partial<Drawing>;
    caption(view: View, texts: SolidTexts): readonly string[];
  };

  /** The lanes of the strip, and how the course learns of the steps that change the current item. */
  readonly lanes: Lanes;
  course(book: Book): Watched;
  /** The additions of its outline. */
  readonly outline: Outlined;
  /** The goals of its runs, besides wrong decisions, the chosen pixel and bookmarks. */
  readonly goals: readonly OwnGoal[];

  /** The owners of the colour that a step painted, by the values after it. Undefined for curves. */
  owners?(event: Event, after: Values, header: Header): Owners;

  /** The questions in exact arithmetic that its decisions about points ask at the point and its neighbours. */
  readonly abouts: Abouts;

  readonly askers: Askers;
  /** The facts that answer a question at a step. */
  facts(view: View): readonly Fact[];
  /** The polygons that a question is about. The question names one itself or none. */
  polygonsAsked(view: View, named: string | null): readonly string[];

  /** The counters that count events by name. */
  readonly counts: Readonly<Partial<Record<Counter, readonly EventName[]>>>;
  /** The other counters. */
  readonly sums: readonly Sum[];
  /** The events that occur at most once for each current item: runs are paired by these steps. */
  readonly landmarks: readonly EventName[];
  landmark(event: Event, current: string): string | null;
}

const algorithms = new Map<Method, Algorithm>();

/** Registers an algorithm; each registers itself once, when the page loads. */
export function defineAlgorithm(methods: readonly Method[], algorithm: Algorithm): void {
  for (const method of methods) algorithms.set(method, algorithm);
}

export function algorithmOf({ method }: { readonly method: Method }): Algorithm {
  const algorithm = algorithms.get(method);
  if (algorithm === undefined) throw new Error(`the algorithm of ${method} was not defined`);
  return algorithm;
}
