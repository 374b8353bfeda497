import { methods } from './format.js';
import type { Cost, Method, Run, Scene } from './format.js';
import { byCost, byError } from './front.js';
import { pointsOf } from './points.js';
import type { Point } from './points.js';

/** Kernels that decide as exact arithmetic would: right in every scene, not in this one alone. */
const alwaysRight: readonly string[] = ['filtered', 'exact'];

/** Which run a scene needs, and why no other: all by one cost. */
export interface Advice {
  /** Of those that get every pixel right. */
  readonly cheapest: Point;
  /** What is cheaper, and so wrong; the least wrong first. */
  readonly cheaper: readonly Point[];
  /** The cheapest of those that are right in every scene; `cheapest` itself, perhaps. None if none has this cost. */
  readonly safe: Point | null;
  /** Of each other method the cheapest right run, by cost. */
  readonly others: readonly Point[];
  readonly neverRight: readonly Method[];
}

/** What one would run: not a text with faults. */
const isSound = ({ complete, setting }: Point): boolean =>
  complete && setting.edition === 'corrected';

/** None if no run is right. */
export function adviceOf(scenes: readonly Scene[], cost: Cost): Advice | null {
  const points = pointsOf(scenes, cost, 'wrongPixels').points.filter(isSound);
  const right = points.filter(({ error }) => error === 0).sort(byCost);
  const [cheapest] = right;
  if (cheapest === undefined) return null;
  const inRun = new Set(points.map(({ setting }) => setting.method));
  const firstOf = (method: Method): Point | undefined =>
    right.find(({ setting }) => setting.method === method);
  const others = methods.filter(
    (method) => inRun.has(method) && method !== cheapest.setting.method,
  );
  return {
    cheapest,
    cheaper: points.filter((point) => point.cost < cheapest.cost).sort(byError),
    safe: right.find(({ setting }) => alwaysRight.includes(setting.kernel)) ?? null,
    others: others.flatMap((method) => firstOf(method) ?? []).sort(byCost),
    neverRight: others.filter((method) => firstOf(method) === undefined),
  };
}

export type Operation = keyof Run['counts'];

/** What most of a run's operations are, and their share; none of a run that took none. */
export function mostly({ counts, operations }: Run): readonly [Operation, number] | null {
  const kinds = Object.entries(counts) as [Operation, number][];
  const [kind, count] = kinds.reduce((most, next) => (next[1] > most[1] ? next : most));
  return operations === 0 ? null : [kind, count / operations];
}
