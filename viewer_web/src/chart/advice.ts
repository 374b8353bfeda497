import { isRightAsGiven } from '../trace/editions.js';
import type { Cost, Run, Subject } from './format.js';
import { byError, pointsOf } from './points.js';
import type { Point } from './points.js';
import { methods } from './scene-format.js';
import type { Method, SceneRun } from './scene-format.js';
import { isOfCurves, settingId } from './series.js';
import type { Setting } from './series.js';
import { axesOf, isSurface } from './subject.js';
import { curveKnobs } from './surface-format.js';
import type { CurveKnob, CurveRun } from './surface-format.js';

/** Whether a run is right in every scene, not only in this one. */
const isSafe = ({ setting }: Point): boolean => isRightAsGiven(setting.kernel);

/** At the same cost, a run that is right everywhere comes first. */
const byCostThenSafety = (a: Point, b: Point): number =>
  a.cost - b.cost || Number(isSafe(b)) - Number(isSafe(a));

/** How a surface's curves are sampled: as in its file, or by a knob. */
export type Sampling = CurveKnob | 'fixed';
/** What advice is about, besides the kernel: a scene's method, or a surface's sampling. */
export type Means = Method | Sampling;

export const isSampling = (means: Means): means is Sampling => !methods.includes(means as Method);

const allMeans: readonly Means[] = [...methods, ...curveKnobs, 'fixed'];

const meansOf = (setting: Setting): Means =>
  isOfCurves(setting) ? (setting.knob ?? 'fixed') : setting.method;

/** Which run a scene or a surface needs, and why no other, by one measure of cost. */
export interface Advice {
  /** The cheapest run that gets every pixel or column right. */
  readonly cheapest: Point;
  /** The cheaper runs, all of them wrong, the least wrong first. */
  readonly cheaper: readonly Point[];
  /** The cheapest run that is right in every scene, possibly `cheapest` itself; null if none has this cost. */
  readonly safe: Point | null;
  /** The cheapest right run by each other means, sorted by cost. */
  readonly others: readonly Point[];
  readonly neverRight: readonly Means[];
  /** Null for scenes. */
  readonly losses: Losses | null;
}

/** The errors of a surface between the samples, and by arithmetic. */
export interface Losses {
  /** The greatest distance between the cheapest run's curves and the function, in pixels. */
  readonly height: number;
  /** For each kernel with wrong decisions, their greatest share in a run. */
  readonly decisions: ReadonlyMap<string, number>;
}

/** Whether a run is worth recommending: complete, and without the defects of the printed edition. */
const isSound = ({ complete, setting }: Point): boolean =>
  complete && setting.edition === 'corrected';

function lossesOf(subjects: readonly Subject[], cost: Cost, cheapest: Point): Losses | null {
  if (!subjects.some(isSurface)) return null;
  const id = settingId(cheapest.setting);
  const heights = pointsOf(subjects, cost, 'height').points;
  const decisions = new Map<string, number>();
  for (const { setting, error } of pointsOf(subjects, cost, 'wrongDecisions').points.filter(
    isSound,
  )) {
    const { kernel } = setting;
    if (error > 0) decisions.set(kernel, Math.max(error, decisions.get(kernel) ?? 0));
  }
  const height = heights.find(({ setting }) => settingId(setting) === id)?.error ?? 0;
  return { height, decisions };
}

/** Null if no run is right. */
export function adviceOf(subjects: readonly Subject[], cost: Cost): Advice | null {
  const [wrong] = axesOf(subjects).errors;
  const points = pointsOf(subjects, cost, wrong).points.filter(isSound);
  const right = points.filter(({ error }) => error === 0).sort(byCostThenSafety);
  const [cheapest] = right;
  if (cheapest === undefined) return null;
  const inRun = new Set(points.map(({ setting }) => meansOf(setting)));
  const firstBy = (means: Means): Point | undefined =>
    right.find(({ setting }) => meansOf(setting) === means);
  const others = allMeans.filter(
    (means) => inRun.has(means) && means !== meansOf(cheapest.setting),
  );
  return {
    cheapest,
    cheaper: points.filter((point) => point.cost < cheapest.cost).sort(byError),
    safe: right.find(isSafe) ?? null,
    others: others.flatMap((means) => firstBy(means) ?? []).sort(byCostThenSafety),
    neverRight: others.filter((means) => firstBy(means) === undefined),
    losses: lossesOf(subjects, cost, cheapest),
  };
}

export type Operation = keyof SceneRun['counts'] | keyof CurveRun['counts'];

/** The most frequent kind of operation in a run, and its share; null for a run without operations. */
export function mostly({ counts, operations }: Run): readonly [Operation, number] | null {
  const kinds = Object.entries(counts) as [Operation, number][];
  const [kind, count] = kinds.reduce((most, next) => (next[1] > most[1] ? next : most));
  return operations === 0 ? null : [kind, count / operations];
}
