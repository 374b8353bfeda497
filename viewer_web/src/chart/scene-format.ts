import { between, bool, list, oneOf, optional, part, text } from '../trace/check.js';
import type { Check, Checked } from '../trace/check.js';
import { isFamily, methodNames } from '../trace/editions.js';
import type { MethodName } from '../trace/editions.js';
import type { Variant } from '../trace/events.js';
import { color, count, editions, file, format, orNull, runOf, size, some } from './checks.js';

/** The method that takes curves. */
const curves = 'floating-horizon';
/** The variants of Warnock's algorithm that the course's methods are compared with. */
export const variants = methodNames.filter(isFamily) as readonly Variant[];
/** The methods of polygons. The variants are last. */
export const methods: readonly Method[] = [
  ...methodNames.filter((name): name is Method => name !== curves && !isFamily(name)),
  ...variants,
];
export const sceneKinds = ['ordinary', 'degenerate'] as const;
export const sceneKnobs = ['bits', 'depth', 'grid', 'window'] as const;
export const sceneCosts = ['time', 'operations', 'bits'] as const;
export const sceneErrors = ['wrongPixels', 'area', 'wrongDecisions', 'depthUlps'] as const;

export type Method = Exclude<MethodName, typeof curves>;

/** JSON has no infinity, so an infinite error of depth is written as a word. */
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

const front = list(oneOf(...sceneErrors));

const runFields = part({
  method: oneOf(...methods),
  kernel: text,
  edition: oneOf(...editions),
  window: count,
  knob: orNull(oneOf(...sceneKnobs)),
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
  picture: optional(count),
});

/** The distinct pictures of the runs, the right one first, each as lengths and colours of runs of pixels in turn. */
const pictures = part({
  width: between(1, 1 << 16),
  colors: list(color),
  shown: some(list(count)),
});

const scene = part({
  name: text,
  kind: oneOf(...sceneKinds),
  unsteady: count,
  pixels: between(1, Number.MAX_SAFE_INTEGER),
  polygons: count,
  area: size,
  runs: some(runOf(runFields, count)),
  scene: file,
  pictures: optional(pictures),
});

export const sceneChart = part({
  format,
  rounds: count,
  scenes: some(scene),
});

export type ScenePictures = Checked<typeof pictures>;
export type SceneRun = Checked<typeof runFields>;
export type Scene = SceneChart['scenes'][number];
export type SceneChart = Checked<typeof sceneChart>;
