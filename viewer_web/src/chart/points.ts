import type { Cost, ErrorMeasure, Run, Scene } from './format.js';
import { frontOf } from './front.js';
import { seriesId, settingId } from './series.js';
import type { Setting } from './series.js';

/** A run in the plot: what it cost and how wrong it was. */
export interface Point {
  readonly setting: Setting;
  /** As the program counted, or in several scenes together a ratio to the least. */
  readonly cost: number;
  /** A share of all pixels or decisions; ulps of a depth. */
  readonly error: number;
  /** Not ended by a fault. */
  readonly complete: boolean;
  readonly front: boolean;
  /** Of a single scene: what was counted. */
  readonly run: Run | null;
}

export interface Points {
  readonly points: readonly Point[];
  /** What has no number for this cost, or did not run in every one of the scenes. */
  readonly missing: readonly Setting[];
}

/** The run's error, made such that scenes of any size can be compared. */
export function relativeError(run: Run, { pixels }: Scene, error: ErrorMeasure): number {
  switch (error) {
    case 'wrongPixels':
    case 'area':
      return run[error] / pixels;
    case 'wrongDecisions':
      return run.decisions === 0 ? 0 : run.wrongDecisions / run.decisions;
    case 'depthUlps':
      return run.depthUlps;
  }
}

/** By how much the right picture itself differs, where that is what is shown. */
export function areaOfRight(scenes: readonly Scene[], error: ErrorMeasure): number | null {
  return error === 'area' ? mean(scenes.map(({ area, pixels }) => area / pixels)) : null;
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

function ofScene(scene: Scene, cost: Cost, error: ErrorMeasure): Points {
  const points: Point[] = [];
  const missing: Setting[] = [];
  for (const run of scene.runs) {
    const found = run[cost];
    if (hasPlace(found)) {
      const front = run.front[cost].includes(error);
      points.push({
        setting: run,
        cost: found,
        error: relativeError(run, scene, error),
        complete: run.complete,
        front,
        run,
      });
    } else missing.push(run);
  }
  return { points, missing };
}

/** Costs as ratios to the scene's least, by setting; the program has done so for the time. */
function ratios({ runs }: Scene, cost: Cost): ReadonlyMap<string, number> {
  const known = runs.flatMap((run) => {
    const found = run[cost];
    return hasPlace(found) ? [[settingId(run), found] as const] : [];
  });
  const least =
    cost === 'time' ? 1 : known.reduce((least, [, found]) => Math.min(least, found), Infinity);
  return new Map(known.map(([id, found]) => [id, found / least]));
}

function together(scenes: readonly Scene[], cost: Cost, error: ErrorMeasure): Points {
  const costs = scenes.map((scene) => ratios(scene, cost));
  const wrong = scenes.map(
    (scene) => new Map(scene.runs.map((run) => [settingId(run), relativeError(run, scene, error)])),
  );
  const settings = new Map(
    scenes.flatMap(({ runs }) => runs.map((run): [string, Setting] => [settingId(run), run])),
  );
  const broken = new Set(
    scenes.flatMap(({ runs }) => runs.filter(({ complete }) => !complete).map(settingId)),
  );
  const points: Omit<Point, 'front'>[] = [];
  const missing: Setting[] = [];
  for (const [id, setting] of settings) {
    const paid = costs.map((each) => each.get(id) ?? NaN);
    const total = geometricMean(paid);
    if (hasPlace(total)) {
      const errors = wrong.map((each) => each.get(id) ?? NaN);
      const joint = error === 'depthUlps' ? Math.max(...errors) : mean(errors);
      points.push({ setting, cost: total, error: joint, complete: !broken.has(id), run: null });
    } else missing.push(setting);
  }
  const front = frontOf(points.filter(({ complete }) => complete));
  return { points: points.map((point) => ({ ...point, front: front.has(point) })), missing };
}

/** The runs of one scene, or each way to run over several: means, but the farthest of depths. */
export function pointsOf(scenes: readonly Scene[], cost: Cost, error: ErrorMeasure): Points {
  const [first, ...others] = scenes;
  if (first === undefined || others.length > 0) return together(scenes, cost, error);
  return ofScene(first, cost, error);
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
