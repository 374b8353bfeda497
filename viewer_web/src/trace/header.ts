import {
  between,
  finite,
  formatOf,
  list,
  matching,
  oneOf,
  optional,
  plainObject,
  record,
  text,
  tuple,
  whole,
} from './check.js';
import type { Check, Checked } from './check.js';
import { edition as anEdition, kernelName } from './editions.js';
import { details, methods } from './events.js';
import { Refusal } from './refusal.js';
import { color } from './values.js';
import type { Sample } from './values.js';

const greatestSide = 16384;
const hexFloat = /^(-?)0x([0-9a-f]+)(?:\.([0-9a-f]*))?(?:p([+-]?\d+))?$/i;

/** A coordinate is a number or a hexadecimal float such as "0x1.8p-3". */
const coordinate: Check<number> = (value, path) => {
  const match = typeof value === 'string' ? hexFloat.exec(value) : null;
  if (match === null) return finite(value, path);
  const [, minus, before = '', after = '', exponent = '0'] = match;
  const digits = Number.parseInt(before + after, 16);
  const size = digits * 2 ** (Number(exponent) - 4 * after.length);
  return finite(minus === '-' ? -size : size, path);
};

const polygon = record({
  id: optional(text),
  color,
  face: optional(text),
  vertices: list(tuple(coordinate, coordinate, coordinate)),
});

const area = record({
  x: whole,
  y: whole,
  width: between(1, greatestSide),
  height: between(1, greatestSide),
});

const sceneFile = record({
  format: formatOf('vidno-scene/1'),
  name: optional(text),
  window: area,
  background: color,
  polygons: list(polygon),
});

/** The samples of each curve, in place of polygons. */
const surfaceFile = record({
  format: formatOf('vidno-surface/1'),
  name: optional(text),
  window: area,
  curves: list(list(tuple(whole, coordinate))),
});

const header = record({
  format: formatOf('vidno-trace/1'),
  method: oneOf(...methods),
  edition: anEdition,
  kernel: matching(kernelName, 'kernel'),
  detail: oneOf(...details),
  scene: plainObject,
});

export type Area = Checked<typeof area>;

export interface Polygon {
  readonly id: string;
  readonly color: string;
  /** Polygons of one face are parts of it: no line is drawn where they meet. */
  readonly face?: string | undefined;
  readonly vertices: readonly (readonly [number, number, number])[];
}

/** From left to right, at least two. */
export type Curve = readonly Sample[];

export interface Scene {
  readonly name: string;
  readonly area: Area;
  readonly background: string;
  readonly polygons: readonly Polygon[];
  readonly byId: ReadonlyMap<string, Polygon>;
  /** From the nearest to the farthest; null for a scene of polygons. A scene of curves has no polygons. */
  readonly curves: readonly Curve[] | null;
}

export interface Header extends Omit<Checked<typeof header>, 'scene' | 'format'> {
  readonly scene: Scene;
}

export function parseHeader(value: unknown): Header {
  const { method, edition, kernel, detail, scene: file } = header(value, '');
  const scene = method === 'floating-horizon' ? surfaceOf(file) : sceneOf(file);
  return { method, edition, kernel, detail, scene };
}

function sceneOf(file: unknown): Scene {
  const drawn = sceneFile(file, 'scene');
  const polygons = drawn.polygons.map((p, i) => ({ ...p, id: p.id ?? String(i) }));
  const byId = new Map<string, Polygon>();
  polygons.forEach((p, i) => {
    if (byId.has(p.id)) throw new Refusal(`scene.polygons[${i}].id`, 'twice');
    byId.set(p.id, p);
  });
  const { name = '', window: shown, background } = drawn;
  return { name, area: shown, background, polygons, byId, curves: null };
}

function surfaceOf(file: unknown): Scene {
  const { name = '', window: shown, curves } = surfaceFile(file, 'scene');
  curves.forEach((curve, i) => expectOnColumns(curve, shown, `scene.curves[${i}]`));
  return { name, area: shown, background: '#ffffff', polygons: [], byId: new Map(), curves };
}

function expectOnColumns(curve: Curve, { x, width }: Area, path: string): void {
  if (curve.length < 2) throw new Refusal(path, 'fewSamples');
  let before = x - 1;
  curve.forEach(([column], i) => {
    if (column <= before) throw new Refusal(`${path}[${i}]`, 'notRight');
    before = column;
  });
  if (before >= x + width) throw new Refusal(path, 'outsideArea');
}
