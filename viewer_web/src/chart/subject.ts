import type { Chart, Cost, ErrorMeasure, Kind, Run, Subject } from './format.js';
import { kinds } from './format.js';
import { sceneCosts, sceneErrors } from './scene-format.js';
import { curveCosts, curveErrors } from './surface-format.js';
import type { Surface, SurfaceChart } from './surface-format.js';

const isOfSurfaces = (chart: Chart): chart is SurfaceChart => 'surfaces' in chart;
export const isSurface = (subject: Subject): subject is Surface => 'columns' in subject;

export function subjectsOf(chart: Chart): readonly Subject[] {
  return isOfSurfaces(chart) ? chart.surfaces : chart.scenes;
}

/** The measures of cost and error of a chart. */
export interface Axes {
  readonly costs: readonly [Cost, ...Cost[]];
  /** The first one is zero for a right picture. */
  readonly errors: readonly [ErrorMeasure, ...ErrorMeasure[]];
}

export function axesOf(subjects: readonly Subject[]): Axes {
  return subjects.some(isSurface)
    ? { costs: curveCosts, errors: curveErrors }
    : { costs: sceneCosts, errors: sceneErrors };
}

function kindOf(subject: Subject): Kind {
  return isSurface(subject) ? 'surfaces' : subject.kind;
}

/** The number of elements that may be wrong: pixels, or columns of the curves. */
export function sizeOf(subject: Subject): number {
  return isSurface(subject) ? subject.columns : subject.pixels;
}

/** The file of a subject, if the chart contains it. */
export function fileOf(subject: Subject): object | undefined {
  return isSurface(subject) ? subject.surface : subject.scene;
}

/** Errors in ulps or pixels: their maximum counts. The other errors are shares. */
export type Distance = 'depthUlps' | 'height';

export function isDistance(error: ErrorMeasure): error is Distance {
  return error === 'depthUlps' || error === 'height';
}

/** Whether a run was not ended by a fault. Runs of the floating horizon have no faults. */
export function isComplete(run: Run): boolean {
  return run.method === 'floating-horizon' || run.complete;
}

export function costOf(run: Run, cost: Cost): number | null {
  const found: Readonly<Partial<Record<Cost, number | null>>> = run;
  return found[cost] ?? null;
}

/** The counted error, not yet divided. */
export function errorOf(run: Run, error: ErrorMeasure): number {
  const found: Readonly<Partial<Record<ErrorMeasure, number>>> = run;
  return found[error] ?? NaN;
}

export function isOnFront({ front }: Run, cost: Cost, error: ErrorMeasure): boolean {
  const found: Readonly<Partial<Record<Cost, readonly ErrorMeasure[]>>> = front;
  return found[cost]?.includes(error) ?? false;
}

/** A view of the chart: one subject, or all subjects of a kind together. */
export interface View {
  /** Its name in the page's address. */
  readonly id: string;
  readonly kind: Kind;
  /** The name of the subject; null for all of the kind. */
  readonly name: string | null;
  readonly subjects: readonly Subject[];
}

/** Subjects with unique names: the second one of the same name gets `(2)`. */
function named(subjects: readonly Subject[]): readonly (readonly [string, Subject])[] {
  const seen = new Map<string, number>();
  return subjects.map((subject) => {
    const { name } = subject;
    const times = (seen.get(name) ?? 0) + 1;
    seen.set(name, times);
    return [times === 1 ? name : `${name} (${times})`, subject];
  });
}

export function viewsOf(chart: Chart): readonly View[] {
  return kinds.flatMap((kind): readonly View[] => {
    const subjects = subjectsOf(chart).filter((subject) => kindOf(subject) === kind);
    const single = named(subjects).map(([name, subject]) => ({
      id: `${kind}/${name}`,
      kind,
      name,
      subjects: [subject],
    }));
    return subjects.length < 2 ? single : [{ id: kind, kind, name: null, subjects }, ...single];
  });
}
