import type { Variant } from '../trace/events.js';
import type { Knob } from './format.js';
import { methods, sceneKnobs, variants } from './scene-format.js';
import type { Method, SceneRun } from './scene-format.js';
import { curveKernels, curveKnobs } from './surface-format.js';
import type { CurveKernel, CurveRun } from './surface-format.js';

type SettingKey = 'method' | 'kernel' | 'edition' | 'knob' | 'value';
type CurveSetting = Pick<CurveRun, SettingKey>;
/** The settings of a run, without its results. */
export type Setting = Pick<SceneRun, SettingKey> | CurveSetting;

/** What the series are grouped by: methods; or kernels, as curves have a single method. */
export type Group = Method | CurveKernel;

/** A group with one of its knobs or none. The reader can add one to the main points. */
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
  none: 'circle',
};

/** The symbols of variants, by position. */
const shapesOfVariants = [
  'hexagon',
  'cross',
  'wye',
  'triangle2',
  'plus',
  'asterisk',
  'times',
] as const;

/** The position of a group among those of its kind, from 1. It determines colour and symbol. */
const placeIn = (groups: readonly Group[], group: Group): number => groups.indexOf(group) + 1;

/** Whether a group is a variant of Warnock's algorithm. Each variant has its own symbol, and no knob. */
export const isVariant = (group: Group): group is Variant => placeIn(variants, group) > 0;
export const isKernel = (group: Group): group is CurveKernel => placeIn(curveKernels, group) > 0;

/** With equal samples, all kernels may have the same point. Their symbols then overlap, the largest at the bottom. */
const scaleOf = (kernel: CurveKernel): number => 1.8 - 0.3 * placeIn(curveKernels, kernel);

export const isOfCurves = (setting: Setting): setting is CurveSetting =>
  setting.method === 'floating-horizon';

const groupOf = (setting: Setting): Group =>
  isOfCurves(setting) ? setting.kernel : setting.method;

const idOf = (group: Group, knob: Knob | null): string => `${group}-${knob ?? 'fixed'}`;

const knobsOf = (group: Group): readonly Knob[] =>
  isKernel(group) ? curveKnobs : isVariant(group) ? [] : sceneKnobs;

export const groups: readonly Group[] = [...methods, ...curveKernels];

/** All possible series, in the order in which they are shown. */
export const allSeries: readonly Series[] = groups.flatMap((group) =>
  [...knobsOf(group), null].map((knob) => ({ id: idOf(group, knob), group, knob })),
);

/** Two series that are of no group: the text as printed, and the runs that nothing cheaper beats. */
export const printed = 'printed';
export const front = 'front';

export function seriesId(setting: Setting): string {
  return idOf(groupOf(setting), setting.knob);
}

/** The series that occur, in order. */
export function seriesOf(settings: readonly Setting[]): readonly Series[] {
  const found = new Set(settings.map(seriesId));
  return allSeries.filter(({ id }) => found.has(id));
}

/** An identifier of a setting, the same in every subject. */
export function settingId({ method, kernel, edition, knob, value }: Setting): string {
  return JSON.stringify([method, kernel, edition, knob, value]);
}

/** The look of a series' points. */
export interface Look {
  readonly color: string;
  readonly shape: Shape;
  /** Symbols of Warnock's algorithm and of curves are filled; those of the Z-buffer and of variants are hollow. */
  readonly isFilled: boolean;
  readonly scale: number;
}

/** Kernels and variants have numbered colours; the others are named after the series. */
function colorOf(group: Group): string | null {
  if (isKernel(group)) return `kernel-${placeIn(curveKernels, group)}`;
  return isVariant(group) ? `variant-${placeIn(variants, group)}` : null;
}

const shapeOfVariant = (variant: Variant): Shape =>
  shapesOfVariants[(placeIn(variants, variant) - 1) % shapesOfVariants.length] ?? 'hexagon';

export function lookOf({ id, group, knob }: Series): Look {
  return {
    color: `var(--${colorOf(group) ?? id})`,
    shape: isVariant(group)
      ? shapeOfVariant(group)
      : id === 'zbuffer-fixed'
        ? 'square'
        : shapeOf[knob ?? 'none'],
    isFilled: group === 'warnock' || isKernel(group),
    scale: isKernel(group) ? scaleOf(group) : 1,
  };
}

/** The look of a run's series. */
export function look(setting: Setting): Look {
  return lookOf({ id: seriesId(setting), group: groupOf(setting), knob: setting.knob });
}
