import type { Cost, ErrorMeasure, Run, Subject } from './format.js';
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

interface Place {
  readonly cost: number;
  readonly error: number;
}

export function byCost(a: Place, b: Place): number {
  return a.cost - b.cost || byError(a, b);
}

/** Compares errors. They may be infinite, so their difference may be NaN. */
export function byError(a: Place, b: Place): number {
  if (a.error === b.error) return a.cost - b.cost;
  return a.error < b.error ? -1 : 1;
}

/** The places that no other one beats in cost or error while at least as good in the other; the first of equal ones. */
export function frontOf<T extends Place>(places: readonly T[]): ReadonlySet<T> {
  const front = new Set<T>();
  let last: Place | null = null;
  for (const place of [...places].sort(byCost)) {
    if (last !== null && place.error >= last.error) continue;
    last = place;
    front.add(place);
  }
  return front;
}

/** A run in the plot: its cost and its error. */
export interface Point {
  readonly setting: Setting;
  /** The counted cost. For several subjects, the mean ratio to the least cost of each. */
  readonly cost: number;
  /** A share of all pixels, columns or decisions; or a distance, in ulps for depths and in pixels for heights. */
  readonly error: number;
  /** Whether it was not ended by a fault. */
  readonly complete: boolean;
  readonly front: boolean;
  /** The run itself, if the chart shows a single subject. */
  readonly run: Run | null;
}

interface Points {
  readonly points: readonly Point[];
  /** The settings without a number for this cost, or without a run in some of the subjects. */
  readonly missing: readonly Setting[];
}

/** The number that an error is divided by: all decisions, or the size of the whole picture. */
export function wholeOf(run: Run, subject: Subject, error: ErrorMeasure): number {
  return error === 'wrongDecisions' ? run.decisions : sizeOf(subject);
}

/** The run's error, comparable between subjects of any size. */
function relativeError(run: Run, subject: Subject, error: ErrorMeasure): number {
  const found = errorOf(run, error);
  return isDistance(error) || found === 0 ? found : found / wholeOf(run, subject, error);
}

/** The error of the right picture itself, if the chart shows areas. */
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

/** A logarithmic axis has no place for zero. */
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

/** Costs by setting, as ratios to the subject's least. The program has already divided the times. */
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

/**
 * The runs of one subject; for several, one point per setting with mean cost and error. Distances have the maximum instead
 * of the mean.
 */
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
