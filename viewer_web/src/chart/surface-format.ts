import { between, finite, list, oneOf, optional, part, text } from '../trace/check.js';
import type { Checked } from '../trace/check.js';
import { plainKernels } from '../trace/editions.js';
import type { PlainKernel } from '../trace/editions.js';
import { count, editions, file, format, orNull, runOf, size, some } from './checks.js';

/** The kernels that run curves; each has its own colour. */
export const curveKernels: readonly CurveKernel[] = plainKernels;
export const curveKnobs = ['samples', 'tolerance'] as const;
export const curveCosts = ['time', 'operations', 'samples'] as const;
export const curveErrors = ['wrongColumns', 'height', 'wrongDecisions'] as const;

export type CurveKernel = PlainKernel;
export type CurveKnob = (typeof curveKnobs)[number];

const counts = part({ visibilities: count, horizons: count, steps: count, crossings: count });

const front = list(oneOf(...curveErrors));

const runFields = part({
  method: oneOf('floating-horizon'),
  kernel: oneOf(...curveKernels),
  edition: oneOf(...editions),
  knob: orNull(oneOf(...curveKnobs)),
  value: orNull(size),
  seconds: size,
  time: size,
  operations: count,
  samples: count,
  counts,
  wrongColumns: count,
  height: size,
  decisions: count,
  wrongDecisions: count,
  front: part({ time: front, operations: front, samples: front }),
  picture: optional(count),
});

/** The distinct drawings of the runs, the right one first, each as lines with x and y of each point in turn. */
const pictures = part({
  width: between(1, 1 << 16),
  height: between(1, 1 << 16),
  shown: some(list(list(finite))),
});

const surface = part({
  name: text,
  curves: count,
  columns: between(1, Number.MAX_SAFE_INTEGER),
  runs: some(runOf(runFields, size)),
  surface: file,
  pictures: optional(pictures),
});

export const surfaceChart = part({
  format,
  rounds: count,
  surfaces: some(surface),
});

export type SurfacePictures = Checked<typeof pictures>;
export type CurveRun = Checked<typeof runFields>;
export type Surface = SurfaceChart['surfaces'][number];
export type SurfaceChart = Checked<typeof surfaceChart>;
