import type { SVGTemplateResult, TemplateResult } from 'lit';
import type { Editing } from '../editor/editor.js';
import { texts } from '../i18n/index.js';
import type { Language } from '../language/language.js';
import type { LegendEntry } from '../language/picture-texts.js';
import type { HistoryTexts, Texts } from '../language/texts.js';
import type { Exact, Layer } from '../picture/layers.js';
import type { Pixel } from '../picture/pixel.js';
import type { Method } from '../trace/events.js';
import type { StatePart } from './state-part.js';
import type { View } from './view.js';

/** Where one chooses what a picture shows. */
export interface LayerChoice extends HTMLElement {
  /** The next of what there is to choose. */
  next(): void;
}

/** What a picture is made of. */
export interface Pictured {
  readonly view: View;
  readonly editing: Editing | null;
  readonly layer: Layer;
  readonly exact: Exact;
  /** Which of the parts that an algorithm's pictures may have are shown: all, until some are chosen. */
  shownOf<T extends string>(all: ReadonlySet<T>): ReadonlySet<T>;
  show<T extends string>(some: ReadonlySet<T>, all: ReadonlySet<T>): void;
  choose(place: Pixel): void;
}

/** The elements that show the runs of an algorithm. */
export interface Shows {
  /** The panel of its state, whole or with some of its parts. */
  readonly state: (view: View, parts: readonly StatePart[] | null) => TemplateResult;
  /** The picture, and the choice of what it shows; their classes are `drawing` and `layers`. */
  readonly picture: (pictured: Pictured) => TemplateResult;
  /** The marks on the picture that the legend explains, and what those look like that no other algorithm has. */
  readonly legend: readonly LegendEntry[];
  readonly icon?: (entry: LegendEntry) => SVGTemplateResult | null;
  /** What is said of a place that is chosen in the picture: a pixel, or a column. */
  readonly places: (texts: Texts) => HistoryTexts;
  /** The form of the scene that is run. */
  readonly form: (editing: Editing, language: Language) => TemplateResult;
  /** What can be done with the scene, in words. */
  readonly how: (texts: Texts) => string;
  /** Whether the scene has polygons, which may be drawn, and shown in 3D. */
  readonly isSolid: boolean;
}

const shows = new Map<Method, Shows>();

/** Makes the elements of an algorithm known; each does so once, as the page is loaded. */
export function defineShows(methods: readonly Method[], its: Shows): void {
  for (const method of methods) shows.set(method, its);
}

function showsOfMethod(method: Method): Shows {
  const found = shows.get(method);
  if (found === undefined) throw new Error(`the elements of ${method} were not defined`);
  return found;
}

export const showsOf = ({ header }: Pick<View, 'header'>): Shows => showsOfMethod(header.method);

/** The same of a scene that is edited. */
export const showsOfEdited = ({ options }: Editing): Shows => showsOfMethod(options.method);

/** What is said of places in the picture of a view, in its language. */
export const placesOf = (view: View): HistoryTexts => showsOf(view).places(texts[view.language]);
