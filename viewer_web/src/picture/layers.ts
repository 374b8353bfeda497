import type { Pixels } from '../replay/screen.js';
import { isPainted, keepsDepths } from '../replay/screen.js';
import type { Screen } from '../replay/screen.js';
import type { Header, Scene } from '../trace/header.js';
import { opaque, textured } from './paint.js';
import type { Cells } from './paint.js';
import { inkAt } from './ramp.js';

/**
 * What the pixels show: the picture so far, the Z-buffer, the exact picture, or the difference between picture and exact
 * picture.
 */
export const layers = ['picture', 'depths', 'exact', 'difference'] as const;
export type Layer = (typeof layers)[number];

/** The picture by exact decisions; null if there is none. */
export type Exact = Pixels | 'computing' | null;

/** That picture, once it is computed. */
export const known = (exact: Exact): Pixels | null => (exact === 'computing' ? null : exact);

export function isLayer(name: string | null): name is Layer {
  return (layers as readonly (string | null)[]).includes(name);
}

export const needsExact = (layer: Layer): boolean => layer === 'exact' || layer === 'difference';

/** The layers that a trace has. */
export function layersOf(header: Header, exact: Exact): readonly Layer[] {
  const hasDepths = header.method === 'zbuffer' && keepsDepths(header);
  return layers.filter(
    (layer) => (layer !== 'depths' || hasDepths) && (!needsExact(layer) || exact !== null),
  );
}

/** The depths of the scene's farthest and nearest vertices. */
export function depthRange({ polygons }: Scene): readonly [far: number, near: number] {
  const depths = polygons.flatMap(({ vertices }) => vertices.map(([, , z]) => z));
  return depths.reduce<readonly [number, number]>(
    ([far, near], z) => [Math.min(far, z), Math.max(near, z)],
    [Infinity, -Infinity],
  );
}

/** The cells that a layer paints; null until they are known. */
export function cellsOf(layer: Layer, { picture, z, scene }: Screen, exact: Exact): Cells | null {
  const { width, height } = picture;
  const rightly = known(exact);
  const cells = (ink: (i: number, j: number) => number): Cells => ({
    width,
    height,
    of: [layer, picture.version, exact],
    row: (j, columns) => {
      const row = new Uint32Array(columns.length);
      for (let at = 0; at < row.length; at++) row[at] = ink(columns[at] ?? 0, j);
      return row;
    },
  });
  switch (layer) {
    case 'picture':
      return cells((i, j) => opaque(picture.at(i, j)));
    case 'depths': {
      const range = depthRange(scene);
      return cells((i, j) => {
        const depth = isPainted(picture.at(i, j)) ? z?.near(i, j) : undefined;
        return depthInk(depth ?? -Infinity, range);
      });
    }
    case 'exact':
      return rightly && cells((i, j) => opaque(rightly.at(i, j)));
    case 'difference':
      return cells((i, j) => {
        const pixel = picture.at(i, j);
        return differing(pixel, rightly?.at(i, j) ?? pixel);
      });
  }
}

function depthInk(depth: number, [far, near]: readonly [number, number]): number {
  if (!Number.isFinite(depth)) return textured('nothing', 0);
  return inkAt(near > far ? (depth - far) / (near - far) : 1);
}

const isSame = (a: number, b: number): boolean => opaque(a) === opaque(b);

function differing(pixel: number, right: number): number {
  const pale = faded(pixel);
  if (isSame(pixel, right)) return opaque(pale);
  return textured(isPainted(pixel) ? 'wrong' : 'lacking', pale);
}

/** A third of the colour, and two thirds white. */
const faded = (pixel: number): number =>
  [0, 8, 16].reduce((all, shift) => {
    const channel = (pixel >>> shift) & 0xff;
    return all | (Math.round(170 + channel / 3) << shift);
  }, 0);

export interface Difference {
  /** Pixels that were painted and do not have the exact colour. */
  readonly wrong: number;
  /** Pixels not painted yet that do not stay background. */
  readonly lacking: number;
}

/** The difference between the picture and the exact one. */
export function differenceOf(picture: Pixels, exact: Pixels): Difference {
  const count = { wrong: 0, lacking: 0 };
  for (let j = 0; j < picture.height; j++) {
    const [row, right] = [picture.row(j), exact.row(j)];
    for (let i = 0; i < picture.width; i++) {
      const pixel = row[i] ?? 0;
      if (!isSame(pixel, right[i] ?? 0)) count[isPainted(pixel) ? 'wrong' : 'lacking']++;
    }
  }
  return count;
}
