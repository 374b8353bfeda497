import { between, bool, finite, list, oneOf, part, plainObject, text } from '../trace/check.js';
import type { Check, Checked } from '../trace/check.js';
import { Refusal, describe } from '../trace/refusal.js';

/** Those of the course, and the variants that are compared with them. */
const courseMethods = ['warnock', 'zbuffer'] as const;
export const variants = [
  'warnock-simplest',
  'warnock-full',
  'warnock-angles',
  'warnock-vertex',
  'warnock-edges',
  'warnock-bodies',
] as const;
export const methods = [...courseMethods, ...variants] as const;
export const editions = ['corrected', 'printed'] as const;
export const kinds = ['ordinary', 'degenerate'] as const;
export const knobs = ['bits', 'depth', 'grid', 'window'] as const;
export const costs = ['time', 'operations', 'bits'] as const;
export const errors = ['wrongPixels', 'area', 'wrongDecisions', 'depthUlps'] as const;

export type Method = (typeof methods)[number];
export type Kind = (typeof kinds)[number];
export type Knob = (typeof knobs)[number];
export type Cost = (typeof costs)[number];
export type ErrorMeasure = (typeof errors)[number];

const size: Check<number> = (value, path) => {
  const number = finite(value, path);
  if (number >= 0) return number;
  throw new Refusal(path, 'notNegative', describe(value));
};

const count = between(0, Number.MAX_SAFE_INTEGER);

function orNull<T>(check: Check<T>): Check<T | null> {
  return (value, path) => (value === null ? null : check(value, path));
}

function some<T>(item: Check<T>): Check<readonly T[]> {
  const all = list(item);
  return (value, path) => {
    const found = all(value, path);
    if (found.length === 0) throw new Refusal(path, 'empty');
    return found;
  };
}

/** JSON has no infinity: a depth that was no number is written as a word. */
const ulps: Check<number> = (value, path) => (value === 'inf' ? Infinity : size(value, path));

const counts = part({
  windows: count,
  boxes: count,
  depths: count,
  orientations: count,
  comparisons: count,
  intersections: count,
  rows: count,
  edges: count,
});

const front = list(oneOf(...errors));

const runFields = part({
  method: oneOf(...methods),
  kernel: text,
  edition: oneOf(...editions),
  window: count,
  knob: orNull(oneOf(...knobs)),
  value: orNull(count),
  complete: bool,
  seconds: size,
  time: size,
  operations: count,
  bits: orNull(count),
  counts,
  wrongPixels: count,
  area: size,
  decisions: count,
  wrongDecisions: count,
  depthUlps: ulps,
  front: part({ time: front, operations: front, bits: front }),
});

/** A knob that was turned was turned somewhere. */
const run: Check<Run> = (value, path) => {
  const found = runFields(value, path);
  if (found.knob !== null) count(found.value, `${path}.value`);
  return found;
};

const sceneFields = part({
  name: text,
  kind: oneOf(...kinds),
  unsteady: count,
  pixels: between(1, Number.MAX_SAFE_INTEGER),
  polygons: count,
  area: size,
  runs: some(run),
});

/** The scene itself need not be told. */
const scene: Check<Scene> = (value, path) => {
  const found = sceneFields(value, path);
  const { scene: file } = plainObject(value, path);
  return file === undefined ? found : { ...found, scene: plainObject(file, `${path}.scene`) };
};

const chart = part({
  format: oneOf('vidno-chart/1'),
  rounds: count,
  scenes: some(scene),
});

export type Run = Checked<typeof runFields>;
export type Scene = Checked<typeof sceneFields> & { readonly scene?: object };
export type Chart = Checked<typeof chart>;

/** What `trace/CHART.md` describes, checked; fields that it does not name are left out. */
export function parseChart(value: unknown): Chart {
  return chart(value, '');
}
