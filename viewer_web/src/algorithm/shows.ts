import type { SVGTemplateResult, TemplateResult } from 'lit';
import type { Editing } from '../editor/editor.js';
import { texts } from '../i18n/index.js';
import type { Language } from '../language/language.js';
import type { LegendEntry } from '../language/texts.js';
import type { HistoryTexts, Texts } from '../language/texts.js';
import type { Exact, Layer } from '../picture/layers.js';
import type { Pixel } from '../picture/pixel.js';
import type { Method } from '../trace/events.js';
import type { View } from './view.js';

/** The parts of the panels of state, which a lesson may ask for by name. Each algorithm has some of them. */
export const stateParts = [
  'window',
  'corner-depths',
  'active-polygons',
  'stack',
  'scanline',
  'active-edges',
  'z-buffer',
  'list',
  'parts',
  'visible',
  'curve',
  'side-edges',
  'horizons',
] as const;
export type StatePart = (typeof stateParts)[number];

/** The control that chooses the layer of a picture. */
export interface LayerChoice extends HTMLElement {
  /** Chooses the next layer. */
  next(): void;
}

/** The content of a picture, and the callbacks for it. */
export interface Pictured {
  readonly view: View;
  readonly editing: Editing | null;
  readonly layer: Layer;
  readonly exact: Exact;
  /** The visible ones of the parts that an algorithm's pictures may have: all, until the reader chooses some. */
  shownOf<T extends string>(all: ReadonlySet<T>): ReadonlySet<T>;
  show<T extends string>(some: ReadonlySet<T>, all: ReadonlySet<T>): void;
  choose(place: Pixel): void;
}

/** The elements that show the runs of an algorithm. */
export interface Shows {
  /** The panel of its state, whole or reduced to some of its parts. */
  readonly state: (view: View, parts: readonly StatePart[] | null) => TemplateResult;
  /** The parts of the panel that have something to show. */
  readonly holds: (view: View) => readonly StatePart[];
  /** The picture with its layer control; their classes are `drawing` and `layers`. */
  readonly picture: (pictured: Pictured) => TemplateResult;
  /** The marks on the picture that the legend explains, and the icons of those that only this algorithm has. */
  readonly legend: readonly LegendEntry[];
  readonly icon?: (entry: LegendEntry) => SVGTemplateResult | null;
  /** The texts about a chosen place in the picture: a pixel or a column. */
  readonly places: (texts: Texts) => HistoryTexts;
  /** The form of the scene. */
  readonly form: (editing: Editing, language: Language) => TemplateResult;
  /** The text that explains how to edit the scene. */
  readonly how: (texts: Texts) => string;
  /** Whether the scene has polygons, which can be drawn by hand and shown in 3D. */
  readonly isSolid: boolean;
}

const shows = new Map<Method, Shows>();

/** Registers the elements of an algorithm; each registers its own once, when the page loads. */
export function defineShows(methods: readonly Method[], its: Shows): void {
  for (const method of methods) shows.set(method, its);
}

function showsOfMethod(method: Method): Shows {
  const found = shows.get(method);
  if (found === undefined) throw new Error(`the elements of ${method} were not defined`);
  return found;
}

export const showsOf = ({ header }: Pick<View, 'header'>): Shows => showsOfMethod(header.method);

/** The elements for a scene that is being edited. */
export const showsOfEdited = ({ options }: Editing): Shows => showsOfMethod(options.method);

/** The texts about places in the picture of a view, in its language. */
export const placesOf = (view: View): HistoryTexts => showsOf(view).places(texts[view.language]);
