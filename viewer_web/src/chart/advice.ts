import { isRightAsGiven } from '../trace/editions.js';
import type { Cost, Run, Subject } from './format.js';
import { byError } from './front.js';
import { pointsOf } from './points.js';
import type { Point } from './points.js';
import { methods } from './scene-format.js';
import type { Method, SceneRun } from './scene-format.js';
import { isOfCurves, settingId } from './series.js';
import type { Setting } from './series.js';
import { axesOf, isSurface } from './subject.js';
import { curveKnobs } from './surface-format.js';
import type { CurveKnob, CurveRun } from './surface-format.js';

/** Right in every scene, not in this one alone. */
const isSafe = ({ setting }: Point): boolean => isRightAsGiven(setting.kernel);

/** What is right everywhere goes before what is as cheap. */
const byCostThenSafety = (a: Point, b: Point): number =>
  a.cost - b.cost || Number(isSafe(b)) - Number(isSafe(a));

/** How a surface's curves are sampled: as its file says, or by a knob. */
export type Sampling = CurveKnob | 'fixed';
/** What advice is about, beside the kernel: a scene's method, or a surface's sampling. */
export type Means = Method | Sampling;

export const isSampling = (means: Means): means is Sampling => !methods.includes(means as Method);

const allMeans: readonly Means[] = [...methods, ...curveKnobs, 'fixed'];

const meansOf = (setting: Setting): Means =>
  isOfCurves(setting) ? (setting.knob ?? 'fixed') : setting.method;

/** Which run a scene or a surface needs, and why no other: all by one cost. */
export interface Advice {
  /** Of those that get every pixel, or every column, right. */
  readonly cheapest: Point;
  /** What is cheaper, and so wrong; the least wrong first. */
  readonly cheaper: readonly Point[];
  /** The cheapest of those that are right in every scene; `cheapest` itself, perhaps. None if none has this cost. */
  readonly safe: Point | null;
  /** By each other means the cheapest right run, by cost. */
  readonly others: readonly Point[];
  readonly neverRight: readonly Means[];
  /** Of surfaces alone. */
  readonly losses: Losses | null;
}

/** What a surface loses between the samples, and what to arithmetic. */
export interface Losses {
  /** How far the cheapest run's curves are from the function at most, in pixels. */
  readonly height: number;
  /** By each kernel that is wrong in a decision, the greatest share of them in a run. */
  readonly decisions: ReadonlyMap<string, number>;
}

/** What one would run: not a text with faults. */
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

/** None if no run is right. */
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

/** What most of a run's operations are, and their share; none of a run that took none. */
export function mostly({ counts, operations }: Run): readonly [Operation, number] | null {
  const kinds = Object.entries(counts) as [Operation, number][];
  const [kind, count] = kinds.reduce((most, next) => (next[1] > most[1] ? next : most));
  return operations === 0 ? null : [kind, count / operations];
}
