import { knobs, methods, variants } from './format.js';
import type { Knob, Method, Run } from './format.js';

/** What was run, without what came out. */
export type Setting = Pick<Run, 'method' | 'kernel' | 'edition' | 'window' | 'knob' | 'value'>;

/** A method with one of its knobs, or without any: what has a colour of its own. */
export interface Series {
  readonly id: string;
  readonly method: Method;
  readonly knob: Knob | null;
}

export const shapes = [
  'circle',
  'square',
  'triangle',
  'diamond2',
  'star',
  'times',
  'plus',
  'asterisk',
  'cross',
  'triangle2',
  'wye',
  'hexagon',
] as const;
export type Shape = (typeof shapes)[number];

const shapeOf: Readonly<Record<Knob | 'none', Shape>> = {
  bits: 'circle',
  depth: 'triangle',
  grid: 'square',
  window: 'diamond2',
  none: 'star',
};

const shapeOfVariant: Readonly<Record<Variant, Shape>> = {
  'warnock-simplest': 'hexagon',
  'warnock-full': 'cross',
  'warnock-angles': 'wye',
  'warnock-vertex': 'triangle2',
  'warnock-edges': 'plus',
  'warnock-bodies': 'asterisk',
};

/** A variant of Warnock's algorithm: each has a symbol of its own, and no knob. */
type Variant = (typeof variants)[number];
export const isVariant = (method: Method): method is Variant => method in shapeOfVariant;

/** All that there may be, in the order in which they are shown. */
export const allSeries: readonly Series[] = methods.flatMap((method) =>
  [...(isVariant(method) ? [] : knobs), null].map((knob) => ({
    id: `${method}-${knob ?? 'fixed'}`,
    method,
    knob,
  })),
);

/** The toggle of the printed edition stands beside those of the series. */
export const printed = 'printed';

export function seriesId({ method, knob }: Setting): string {
  return `${method}-${knob ?? 'fixed'}`;
}

/** The series that occur, in order. */
export function seriesOf(settings: readonly Setting[]): readonly Series[] {
  const found = new Set(settings.map(seriesId));
  return allSeries.filter(({ id }) => found.has(id));
}

/** The same way to run in every scene. */
export function settingId({ method, kernel, edition, window, knob }: Setting): string {
  return JSON.stringify([method, kernel, edition, window, knob]);
}

export function shape({ method, knob }: Pick<Setting, 'method' | 'knob'>): Shape {
  if (isVariant(method)) return shapeOfVariant[method];
  return shapeOf[knob ?? 'none'];
}

export function isHidden(setting: Setting, hidden: ReadonlySet<string>): boolean {
  return hidden.has(seriesId(setting)) || (setting.edition === printed && hidden.has(printed));
}
