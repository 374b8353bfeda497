import type { Cost, ErrorMeasure, Run, Subject } from './format.js';
import { frontOf } from './front.js';
import { seriesId, settingId } from './series.js';
import type { Setting } from './series.js';
import {
  costOf,
  errorOf,
  isComplete,
  isDistance,
  isOnFront,
  isSurface,
  sizeOf,
} from './subject.js';

/** A run in the plot: what it cost and how wrong it was. */
export interface Point {
  readonly setting: Setting;
  /** As the program counted, or in several subjects together a ratio to the least. */
  readonly cost: number;
  /** A share of all pixels, columns or decisions; ulps of a depth, pixels of a height. */
  readonly error: number;
  /** Not ended by a fault. */
  readonly complete: boolean;
  readonly front: boolean;
  /** Of a single subject: what was counted. */
  readonly run: Run | null;
}

export interface Points {
  readonly points: readonly Point[];
  /** What has no number for this cost, or did not run in every one of the subjects. */
  readonly missing: readonly Setting[];
}

/** Of how much an error is a share: of the decisions, or of the whole picture. */
export function wholeOf(run: Run, subject: Subject, error: ErrorMeasure): number {
  return error === 'wrongDecisions' ? run.decisions : sizeOf(subject);
}

/** The run's error, made such that subjects of any size can be compared. */
function relativeError(run: Run, subject: Subject, error: ErrorMeasure): number {
  const found = errorOf(run, error);
  return isDistance(error) || found === 0 ? found : found / wholeOf(run, subject, error);
}

/** By how much the right picture itself differs, where that is what is shown. */
export function areaOfRight(subjects: readonly Subject[], error: ErrorMeasure): number | null {
  if (error !== 'area') return null;
  return mean(subjects.map((subject) => (isSurface(subject) ? 0 : subject.area / subject.pixels)));
}

function mean(values: readonly number[]): number {
  return values.reduce((sum, value) => sum + value / values.length, 0);
}

function geometricMean(values: readonly number[]): number {
  return Math.exp(mean(values.map(Math.log)));
}

/** A logarithmic axis has no place for nothing. */
const hasPlace = (cost: number | null): cost is number =>
  cost !== null && cost > 0 && Number.isFinite(cost);

function ofOne(subject: Subject, cost: Cost, error: ErrorMeasure): Points {
  const points: Point[] = [];
  const missing: Setting[] = [];
  for (const run of subject.runs) {
    const found = costOf(run, cost);
    if (hasPlace(found)) {
      points.push({
        setting: run,
        cost: found,
        error: relativeError(run, subject, error),
        complete: isComplete(run),
        front: isOnFront(run, cost, error),
        run,
      });
    } else missing.push(run);
  }
  return { points, missing };
}

/** Costs as ratios to the subject's least, by setting; the program has done so for the time. */
function ratios({ runs }: Subject, cost: Cost): ReadonlyMap<string, number> {
  const known = runs.flatMap((run: Run) => {
    const found = costOf(run, cost);
    return hasPlace(found) ? [[settingId(run), found] as const] : [];
  });
  const least =
    cost === 'time' ? 1 : known.reduce((least, [, found]) => Math.min(least, found), Infinity);
  return new Map(known.map(([id, found]) => [id, found / least]));
}

function together(subjects: readonly Subject[], cost: Cost, error: ErrorMeasure): Points {
  const costs = subjects.map((subject) => ratios(subject, cost));
  const wrong = subjects.map(
    (subject) =>
      new Map(subject.runs.map((run) => [settingId(run), relativeError(run, subject, error)])),
  );
  const runs: readonly Run[] = subjects.flatMap((subject): readonly Run[] => subject.runs);
  const settings = new Map(runs.map((run): [string, Setting] => [settingId(run), run]));
  const broken = new Set(runs.filter((run) => !isComplete(run)).map(settingId));
  const points: Omit<Point, 'front'>[] = [];
  const missing: Setting[] = [];
  for (const [id, setting] of settings) {
    const paid = costs.map((each) => each.get(id) ?? NaN);
    const total = geometricMean(paid);
    if (hasPlace(total)) {
      const errors = wrong.map((each) => each.get(id) ?? NaN);
      const joint = isDistance(error) ? Math.max(...errors) : mean(errors);
      points.push({ setting, cost: total, error: joint, complete: !broken.has(id), run: null });
    } else missing.push(setting);
  }
  const front = frontOf(points.filter(({ complete }) => complete));
  return { points: points.map((point) => ({ ...point, front: front.has(point) })), missing };
}

/** The runs of one subject, or each way to run over several: means, but the farthest of depths and heights. */
export function pointsOf(subjects: readonly Subject[], cost: Cost, error: ErrorMeasure): Points {
  const [first, ...others] = subjects;
  if (first === undefined || others.length > 0) return together(subjects, cost, error);
  return ofOne(first, cost, error);
}

/** Points of one knob, method and edition, in the order of the knob's value. */
export function linesOf(points: readonly Point[]): readonly (readonly Point[])[] {
  const lines = new Map<string, Point[]>();
  for (const point of points) {
    const { knob, edition } = point.setting;
    if (knob === null) continue;
    const id = `${seriesId(point.setting)} ${edition}`;
    lines.set(id, [...(lines.get(id) ?? []), point]);
  }
  const value = ({ setting }: Point): number => setting.value ?? 0;
  return [...lines.values()].map((line) => line.sort((a, b) => value(a) - value(b)));
}
