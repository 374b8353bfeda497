import type { Chart, Cost, ErrorMeasure, Kind, Run, Subject } from './format.js';
import { sceneCosts, sceneErrors } from './scene-format.js';
import { curveCosts, curveErrors } from './surface-format.js';
import type { Surface, SurfaceChart } from './surface-format.js';

const isOfSurfaces = (chart: Chart): chart is SurfaceChart => 'surfaces' in chart;
export const isSurface = (subject: Subject): subject is Surface => 'columns' in subject;

export function subjectsOf(chart: Chart): readonly Subject[] {
  return isOfSurfaces(chart) ? chart.surfaces : chart.scenes;
}

/** What a chart's runs are measured by. */
export interface Axes {
  readonly costs: readonly [Cost, ...Cost[]];
  /** The first is none where the picture is right. */
  readonly errors: readonly [ErrorMeasure, ...ErrorMeasure[]];
}

export function axesOf(subjects: readonly Subject[]): Axes {
  return subjects.some(isSurface)
    ? { costs: curveCosts, errors: curveErrors }
    : { costs: sceneCosts, errors: sceneErrors };
}

export function kindOf(subject: Subject): Kind {
  return isSurface(subject) ? 'surfaces' : subject.kind;
}

/** How much of it may be wrong: pixels, or columns of its curves. */
export function sizeOf(subject: Subject): number {
  return isSurface(subject) ? subject.columns : subject.pixels;
}

/** The file that it was run from, if the chart holds it. */
export function fileOf(subject: Subject): object | undefined {
  return isSurface(subject) ? subject.surface : subject.scene;
}

/** In ulps or pixels: the farthest counts. Other errors are shares. */
export type Distance = 'depthUlps' | 'height';

export function isDistance(error: ErrorMeasure): error is Distance {
  return error === 'depthUlps' || error === 'height';
}

/** Not ended by a fault; nothing of the floating horizon has one. */
export function isComplete(run: Run): boolean {
  return run.method === 'floating-horizon' || run.complete;
}

export function costOf(run: Run, cost: Cost): number | null {
  const found: Readonly<Partial<Record<Cost, number | null>>> = run;
  return found[cost] ?? null;
}

/** As it was counted, not of how much. */
export function errorOf(run: Run, error: ErrorMeasure): number {
  const found: Readonly<Partial<Record<ErrorMeasure, number>>> = run;
  return found[error] ?? NaN;
}

export function isOnFront({ front }: Run, cost: Cost, error: ErrorMeasure): boolean {
  const found: Readonly<Partial<Record<Cost, readonly ErrorMeasure[]>>> = front;
  return found[cost]?.includes(error) ?? false;
}
