import { isRightAsGiven } from '../trace/editions.js';
import type { Cost, Subject } from './format.js';
import { pointsOf } from './points.js';
import type { Point } from './points.js';
import { isOfCurves, settingId } from './series.js';
import type { Setting } from './series.js';
import { axesOf } from './subject.js';

/** The arithmetics in which the chart compares the methods. */
const compared: readonly string[] = ['float', 'double', 'filtered', 'exact'];

/** Whether a run is right in every scene, not only in this one. */
const isSafe = ({ setting }: Point): boolean => isRightAsGiven(setting.kernel);

/** At the same cost, a run that is right everywhere comes first. */
const byCostThenSafety = (a: Point, b: Point): number =>
  a.cost - b.cost || Number(isSafe(b)) - Number(isSafe(a));

const isOfCourse = ({ method, knob }: Setting): boolean =>
  (method === 'zbuffer' || method === 'warnock') && knob === null;

/** For each kernel, the two methods of the course, and the fastest right run of all others. */
function ofScenes(points: readonly Point[]): readonly Point[] {
  const others = points.filter(({ setting }) => !isOfCourse(setting) && setting.knob === null);
  return [...points.filter(({ setting }) => isOfCourse(setting)), ...rightOnes(others).slice(0, 1)];
}

/** For each kernel, the samples of the file and one on each column; then the cheapest right run with fewer, by each knob. */
function ofSurfaces(points: readonly Point[]): readonly Point[] {
  const turned = (knob: Setting['knob']): readonly Point[] =>
    points.filter(({ setting }) => setting.knob === knob);
  const samples = turned('samples');
  const most = Math.max(...samples.map(({ setting }) => setting.value ?? 0));
  const densest = samples.filter(({ setting }) => setting.value === most);
  const fewer = samples.filter((point) => !densest.includes(point));
  return [
    ...turned(null),
    ...densest,
    ...rightOnes(fewer).slice(0, 1),
    ...rightOnes(turned('tolerance')).slice(0, 1),
  ];
}

/** The right ones, the cheapest first. */
function rightOnes(points: readonly Point[]): readonly Point[] {
  return points.filter(({ error }) => error === 0).sort(byCostThenSafety);
}

/** The few runs that the chart opens with, at most twelve, as the answer to what a right picture costs. */
export interface Main {
  /** Their settings by `settingId`. */
  readonly ids: ReadonlySet<string>;
  /** The cheapest one that gets every pixel or column right; null if none does. */
  readonly cheapest: Point | null;
  /** The cheapest one that is right in every scene, possibly `cheapest` itself; null if none has this cost. */
  readonly safe: Point | null;
  /** Of the cheaper ones, which are all wrong, the least wrong. */
  readonly wrong: Point | null;
}

export function mainOf(subjects: readonly Subject[], cost: Cost): Main {
  const [wrongParts] = axesOf(subjects).errors;
  // The printed edition has defects, and a run that a fault ended has no picture.
  const points = pointsOf(subjects, cost, wrongParts).points.filter(
    ({ complete, setting: { edition, kernel } }) =>
      complete && edition === 'corrected' && compared.includes(kernel),
  );
  const main = points.some(({ setting }) => isOfCurves(setting))
    ? ofSurfaces(points)
    : ofScenes(points);
  const right = rightOnes(main);
  const cheapest = right[0] ?? null;
  const cheaper = cheapest === null ? main : main.filter((point) => point.cost < cheapest.cost);
  const leastWrong = [...cheaper].sort((a, b) => a.error - b.error || a.cost - b.cost);
  return {
    ids: new Set(main.map(({ setting }) => settingId(setting))),
    cheapest,
    safe: right.find(isSafe) ?? null,
    wrong: leastWrong[0] ?? null,
  };
}
