import type { Knob } from './format.js';
import { methods, sceneKnobs, variants } from './scene-format.js';
import type { Method, SceneRun } from './scene-format.js';
import { curveKernels, curveKnobs } from './surface-format.js';
import type { CurveKernel, CurveRun } from './surface-format.js';

type Told = 'method' | 'kernel' | 'edition' | 'knob' | 'value';
type CurveSetting = Pick<CurveRun, Told>;
/** What was run, without what came out. */
export type Setting = Pick<SceneRun, Told> | CurveSetting;

/** What the series are of: methods, or of curves, which have one method, kernels. */
export type Group = Method | CurveKernel;

/** A group with one of its knobs, or without any: what can be hidden. */
export interface Series {
  readonly id: string;
  readonly group: Group;
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
  samples: 'square',
  tolerance: 'circle',
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

/** On one sampling all kernels may come to one place: there their symbols lie on each other, the greatest below. */
const scaleOf: Readonly<Record<CurveKernel, number>> = {
  float: 1.5,
  double: 1.2,
  filtered: 0.9,
  exact: 0.55,
};

/** A variant of Warnock's algorithm: each has a symbol of its own, and no knob. */
type Variant = (typeof variants)[number];
export const isVariant = (group: Group): group is Variant => group in shapeOfVariant;
export const isKernel = (group: Group): group is CurveKernel => group in scaleOf;

export const isOfCurves = (setting: Setting): setting is CurveSetting =>
  setting.method === 'floating-horizon';

const groupOf = (setting: Setting): Group =>
  isOfCurves(setting) ? setting.kernel : setting.method;

const idOf = (group: Group, knob: Knob | null): string => `${group}-${knob ?? 'fixed'}`;

const knobsOf = (group: Group): readonly Knob[] =>
  isKernel(group) ? curveKnobs : isVariant(group) ? [] : sceneKnobs;

export const groups: readonly Group[] = [...methods, ...curveKernels];

/** All that there may be, in the order in which they are shown. */
export const allSeries: readonly Series[] = groups.flatMap((group) =>
  [...knobsOf(group), null].map((knob) => ({ id: idOf(group, knob), group, knob })),
);

/** The toggle of the printed edition stands beside those of the series. */
export const printed = 'printed';

export function seriesId(setting: Setting): string {
  return idOf(groupOf(setting), setting.knob);
}

/** The series that occur, in order. */
export function seriesOf(settings: readonly Setting[]): readonly Series[] {
  const found = new Set(settings.map(seriesId));
  return allSeries.filter(({ id }) => found.has(id));
}

/** The same way to run in every subject. */
export function settingId({ method, kernel, edition, knob, value }: Setting): string {
  return JSON.stringify([method, kernel, edition, knob, value]);
}

/** How the points of a series are drawn. */
export interface Look {
  readonly color: string;
  readonly shape: Shape;
  /** Symbols of Warnock's algorithm and of curves are filled, those of the Z-buffer and of variants are hollow. */
  readonly isFilled: boolean;
  readonly scale: number;
}

export function lookOf({ id, group, knob }: Series): Look {
  return {
    color: `var(--${isKernel(group) ? group : id})`,
    shape: isVariant(group) ? shapeOfVariant[group] : shapeOf[knob ?? 'none'],
    isFilled: group === 'warnock' || isKernel(group),
    scale: isKernel(group) ? scaleOf[group] : 1,
  };
}

/** That of a run's series. */
export function look(setting: Setting): Look {
  return lookOf({ id: seriesId(setting), group: groupOf(setting), knob: setting.knob });
}

export function isHidden(setting: Setting, hidden: ReadonlySet<string>): boolean {
  return hidden.has(seriesId(setting)) || (setting.edition === printed && hidden.has(printed));
}
