import { editionsOf, kernels, runs } from '../run/options.js';
import type { Options } from '../run/options.js';
import { details, methods } from '../trace/events.js';
import type { Method } from '../trace/events.js';

/** A run to make, with the text of its scene. */
export interface RandomRun {
  readonly scene: string;
  readonly options: Options;
}

/** Pseudorandom numbers, by the generator of Park and Miller. */
class Chance {
  constructor(private state: number) {}

  below(n: number): number {
    this.state = (this.state * 48271) % 2147483647;
    return Math.floor((this.state / 2147483647) * n);
  }

  of<T>(list: readonly T[]): T {
    const found = list[this.below(list.length)];
    if (found === undefined) throw new Error('an empty list');
    return found;
  }

  /** A number in quarters, from a lower bound to an upper one. */
  quarter(low: number, high: number): number {
    return low + this.below(4 * (high - low) + 1) / 4;
  }

  /** A number in tenths, which are rounded, so that decisions may be wrong. */
  tenth(low: number, high: number): number {
    return low + this.below(10 * (high - low) + 1) / 10;
  }
}

type Vertex = readonly [number, number, number];
type Outline = readonly Vertex[];

const area = { x: -1, y: 2, width: 4, height: 3 };
const ids = ['Alfa', 'Beta', 'Gama', 'Delt'];
const background = '#ffffff';
/** Few colours, so that polygons have the same colour as others or as the background. */
const colors = [background, '#aa0000', '#00aa00'];

const at = (chance: Chance): Vertex => [
  chance.quarter(area.x - 1, area.x + area.width + 1),
  chance.quarter(area.y - 1, area.y + area.height + 1),
  chance.quarter(-1, 1),
];

const inTenths = (chance: Chance): Vertex => [
  chance.tenth(area.x - 1, area.x + area.width + 1),
  chance.tenth(area.y - 1, area.y + area.height + 1),
  chance.tenth(-1, 1),
];

function triangle(chance: Chance): Outline {
  const vertex = chance.of([at, inTenths]);
  return [vertex(chance), vertex(chance), vertex(chance)];
}

/** Its depths lie on one plane. */
function rectangle(chance: Chance): Outline {
  const [left, top, z] = at(chance);
  const [right, bottom] = [left + chance.quarter(1, 5), top + chance.quarter(1, 4)];
  const [across, down] = [chance.quarter(-1, 1) / 16, chance.quarter(-1, 1) / 16];
  const spot = (x: number, y: number): Vertex => [
    x,
    y,
    z / 4 + across * (x - left) + down * (y - top),
  ];
  return [spot(left, top), spot(right, top), spot(right, bottom), spot(left, bottom)];
}

/** It contains the whole area. */
const cover = (chance: Chance): Outline => {
  const z = chance.quarter(-1, 1);
  const [right, bottom] = [area.x + area.width + 2, area.y + area.height + 2];
  return [
    [area.x - 2, area.y - 2, z],
    [right, area.y - 2, z],
    [right, bottom, z],
    [area.x - 2, bottom, z],
  ];
};

/** On a line through centres of pixels. */
function edgeOn(chance: Chance): Outline {
  const [x, , z] = at(chance);
  const y = area.y + chance.below(area.height) + 0.5;
  return [
    [x, y, z],
    [x + 3, y, 0],
    [x + 1.5, y, -z],
  ];
}

/**
 * A closed box. Its faces are counter-clockwise as seen from outside, where y grows downward and nearer places have the
 * greater z.
 */
function box(chance: Chance): readonly Outline[] {
  const [x, y] = at(chance);
  const z = chance.quarter(-1, 0);
  const [right, bottom, near] = [x + chance.quarter(1, 3), y + chance.quarter(1, 3), 1];
  const face = (...corners: readonly string[]): Outline =>
    corners.map((corner) => [
      corner.includes('r') ? right : x,
      corner.includes('b') ? bottom : y,
      corner.includes('n') ? near : z,
    ]);
  return [
    face('n', 'bn', 'brn', 'rn'),
    face('', 'r', 'br', 'b'),
    face('', 'b', 'bn', 'n'),
    face('r', 'rn', 'brn', 'br'),
    face('', 'n', 'rn', 'r'),
    face('b', 'br', 'brn', 'bn'),
  ];
}

function outlinesFor(method: Method, chance: Chance): readonly Outline[] {
  if (method === 'warnock-bodies') return box(chance);
  const kinds = [triangle, triangle, rectangle, cover];
  const count = 1 + chance.below(ids.length);
  const all = Array.from({ length: count }, () => chance.of(kinds)(chance));
  return method === 'warnock-edges' ? [edgeOn(chance), ...all.slice(1)] : all;
}

function polygonScene(method: Method, chance: Chance): object {
  const names = method === 'warnock-bodies' ? [...ids, 'Epsi', 'Zeta'] : ids;
  const polygons = outlinesFor(method, chance).map((vertices, i) => ({
    id: names[i],
    color: chance.of(colors),
    vertices,
  }));
  return { format: 'vidno-scene/1', window: area, background, polygons };
}

function surface(chance: Chance): object {
  const columns = Array.from({ length: area.width }, (_, i) => area.x + i);
  const curve = (): unknown =>
    columns
      .filter((_, i) => i === 0 || i === columns.length - 1 || chance.below(2) === 0)
      .map((x) => [x, chance.quarter(area.y, area.y + area.height)]);
  const curves = Array.from({ length: 2 + chance.below(3) }, curve);
  return { format: 'vidno-surface/1', window: area, curves };
}

/**
 * Runs of random scenes: all methods in turn, in any of their editions and under any of their kernels. A seed always gives
 * the same runs.
 */
export function randomRuns(count: number, seed: number): readonly RandomRun[] {
  const chance = new Chance(seed);
  return Array.from({ length: count }, (_, i) => {
    const method = methods[i % methods.length] ?? 'warnock';
    const edition = chance.of(editionsOf(method));
    const kernel = chance.of(kernels.filter((each) => runs({ method, edition, kernel: each })));
    const check = chance.below(2) === 0;
    const options = { method, edition, kernel, detail: chance.of(details), check };
    const scene = method === 'floating-horizon' ? surface(chance) : polygonScene(method, chance);
    return { scene: JSON.stringify(scene), options };
  });
}
