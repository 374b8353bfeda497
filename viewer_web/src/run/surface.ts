import type { Curve } from '../trace/header.js';
import type { Sample } from '../trace/values.js';
import type { Sketch } from './sketch.js';

type Pair = readonly [number, number];

/** A surface y = f(x, z), and how its curves are cut and seen: the members of a function in `vidno-surface/1`. */
export interface Formula {
  readonly function: string;
  readonly x: Pair;
  readonly z: Pair;
  readonly curves: number;
  readonly samples: number;
  readonly tolerance?: number;
  readonly view: {
    readonly origin: Pair;
    readonly across: Pair;
    readonly back: Pair;
    readonly up: number;
  };
}

/** A sample of a sketch, by the indices of its curve and of the sample. */
export interface SampleSpot {
  readonly curve: number;
  readonly sample: number;
}

const format = 'vidno-surface/1';

/** The file of a surface on one line: with the function if there is one, or else with the samples. */
export function surfaceText({ name, area, curves, formula }: Sketch): string {
  const begun = { format, name, window: area };
  return JSON.stringify(formula === undefined ? { ...begun, curves } : { ...begun, ...formula });
}

/** The members of a file; null if it is not an object. */
function membersOf(text: string): Readonly<Record<string, unknown>> | null {
  try {
    const file: unknown = JSON.parse(text);
    return typeof file === 'object' && file !== null ? { ...file } : null;
  } catch {
    return null;
  }
}

const kindOf = (name: unknown): string => String(name).replace(/\/.*$/u, '');

/** Whether a text is the file of a surface, of any version or without a format. */
export function isSurface(text: string): boolean {
  const file = membersOf(text);
  if (file === null) return false;
  return 'format' in file
    ? kindOf(file['format']) === kindOf(format)
    : 'curves' in file || 'function' in file;
}

/** The function in a surface's file; undefined if the file has samples. */
export function formulaOf(text: string): Formula | undefined {
  if (!isSurface(text)) return undefined;
  const file = JSON.parse(text) as Partial<Formula>;
  return 'function' in file ? onlyFormula(file as Formula) : undefined;
}

/** Drops the other members of its file. */
function onlyFormula(of: Omit<Formula, 'tolerance'> & { tolerance?: number | undefined }): Formula {
  const { function: text, x, z, curves, samples, tolerance, view } = of;
  const formula = { function: text, x, z, curves, samples, view };
  return tolerance === undefined ? formula : { ...formula, tolerance };
}

/** The current curves of a sketch: its own, or for a function those of the current run. */
const curvesNow = ({ formula, curves }: Sketch, shown: readonly Curve[]): readonly Curve[] =>
  formula === undefined && curves !== null ? curves : shown;

/**
 * Moves a sample up or down to the height that `to` computes; its column stays. A surface given as a function is replaced
 * by its samples, those of the current run.
 */
export function moveSample(
  sketch: Sketch,
  shown: readonly Curve[],
  { curve, sample }: SampleSpot,
  to: (at: Sample) => number,
): Sketch {
  const curves = curvesNow(sketch, shown);
  const old = curves[curve]?.[sample];
  if (old === undefined || old[1] === null) return sketch;
  const y = to([old[0], old[1]]);
  if (old[1] === y) return sketch;
  const moved = (of: Curve): Curve =>
    of.map((each, i) => (i === sample ? ([each[0], y] as const) : each));
  const { name, area, background, polygons } = sketch;
  return {
    name,
    area,
    background,
    polygons,
    curves: curves.map((of, i) => (i === curve ? moved(of) : of)),
  };
}

/** Changes the function, or how it is cut and seen. */
export function withFormula(sketch: Sketch, change: Partial<Formula>): Sketch {
  const { formula } = sketch;
  return formula === undefined ? sketch : { ...sketch, formula: { ...formula, ...change } };
}

/** Takes exactly the requested number of samples, and no more where the curve bends. */
export function withoutTolerance(sketch: Sketch): Sketch {
  const { formula } = sketch;
  if (formula?.tolerance === undefined) return sketch;
  return { ...sketch, formula: onlyFormula({ ...formula, tolerance: undefined }) };
}

/** An initial function for an area of this size: a wave. */
export function firstFormula({ area: { x, y, width, height } }: Sketch): Formula {
  const part = (of: number, by: number): number => Math.round(of * by);
  const curves = 21;
  const across = Math.max(1, part(width, 0.6));
  const back: Pair = [
    Math.max(0, Math.floor((0.3 * width) / curves)),
    -Math.max(1, part(height, 0.015)),
  ];
  return {
    function: 'sin(x) * cos(z)',
    x: [0, 6.3],
    z: [6.3, 0],
    curves,
    samples: Math.min(31, across + 1), // at most one for each column
    view: {
      origin: [x + part(width, 0.05), y + part(height, 0.65)],
      across: [across, part(height, 0.1)],
      back,
      up: part(height, 0.12) || 1,
    },
  };
}

/** An initial surface. */
export function firstSurface(name: string): Sketch {
  const area = { x: 0, y: 0, width: 160, height: 120 };
  const sketch = { name, area, background: '#ffffff', polygons: [], curves: [] };
  return { ...sketch, formula: firstFormula(sketch) };
}
