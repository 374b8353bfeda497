import type { Point } from '../picture/frame.js';
import type { Area } from '../trace/header.js';
import type { Spot } from './space.js';

/**
 * The direction from which the box is seen, in degrees: how far to the right of its front, and how far above it, the viewer
 * is.
 */
export interface Turn {
  readonly right: number;
  readonly above: number;
}

/** The predefined views; the front view looks like the picture. */
export const views = {
  front: { right: 0, above: 0 },
  side: { right: -90, above: 0 },
  askew: { right: -35, above: 25 },
} as const satisfies Readonly<Record<string, Turn>>;
export type ViewName = keyof typeof views;
export const viewNames = Object.keys(views) as readonly ViewName[];

/** The viewer never goes behind the box: from there left would be right. */
const limited = (degrees: number): number => Math.min(Math.max(degrees, -90), 90);

export const turned = ({ right, above }: Turn, by: Turn): Turn => ({
  right: limited(right + by.right),
  above: limited(above + by.above),
});

export const isSame = (a: Turn, b: Turn): boolean => a.right === b.right && a.above === b.above;

const sineAndCosine = (degrees: number): readonly [number, number] => {
  const angle = (degrees * Math.PI) / 180;
  return [Math.sin(angle), Math.cos(angle)];
};

/** The position of a place of the box in the view, y downward, relative to the middle. The projection is parallel. */
export function seen({ right, above }: Turn, [x, y, z]: Spot): Point {
  const [sr, cr] = sineAndCosine(right);
  const [sa, ca] = sineAndCosine(above);
  return [x * cr - z * sr, x * sr * sa + y * ca + z * cr * sa];
}

/** The direction to the viewer, y upward. */
export function toViewer({ right, above }: Turn): Spot {
  const [sr, cr] = sineAndCosine(right);
  const [sa, ca] = sineAndCosine(above);
  return [sr * ca, sa, cr * ca];
}

/** The upward direction of the view, y upward. */
export function upward({ right, above }: Turn): Spot {
  const [sr, cr] = sineAndCosine(right);
  const [sa, ca] = sineAndCosine(above);
  return [-sr * sa, ca, -cr * sa];
}

/** The room for labels, as a share of half the longer side. */
const room = 0.03;

/** The extent of a box of this size in a view, with room for labels. */
export function extent(turn: Turn, [width, height, depth]: Spot): Area {
  const corners = [-0.5, 0.5].flatMap((i) =>
    [-0.5, 0.5].map((j) => seen(turn, [width * i, height * j, depth / 2])),
  );
  const reach = (axis: 0 | 1): number => Math.max(...corners.map((at) => Math.abs(at[axis])));
  const around = Math.max(reach(0), reach(1)) * room;
  const [x, y] = [reach(0) + around, reach(1) + around];
  return { x: -x, y: -y, width: 2 * x, height: 2 * y };
}
