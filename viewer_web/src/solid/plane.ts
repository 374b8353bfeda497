import type { Polygon } from '../trace/header.js';
import type { Box } from '../trace/values.js';
import type { Spot } from './space.js';

/** The depth of a plane at a point; not finite where the plane is seen edge-on. */
export type Plane = (x: number, y: number) => number;

/** The plane of a polygon, for drawing alone: Newell's sum about the first vertex. */
export function planeOf({ vertices }: Polygon): Plane {
  const [[x0, y0, z0] = [0, 0, 0]] = vertices;
  let [a, b, c] = [0, 0, 0];
  vertices.forEach((from, i) => {
    const to = vertices[(i + 1) % vertices.length] ?? from;
    const [x1, y1, z1] = [from[0] - x0, from[1] - y0, from[2] - z0];
    const [x2, y2, z2] = [to[0] - x0, to[1] - y0, to[2] - z0];
    a += y1 * z2 - z1 * y2;
    b += z1 * x2 - x1 * z2;
    c += x1 * y2 - y1 * x2;
  });
  return (x, y) => (c === 0 ? NaN : z0 - (a * (x - x0) + b * (y - y0)) / c);
}

/** A rectangle's corners, going round. */
export const around = ([x, y, width, height]: Box): readonly (readonly [number, number])[] => [
  [x, y],
  [x + width, y],
  [x + width, y + height],
  [x, y + height],
];

/** What of a plane lies over a window between two depths. */
export function patchOf(plane: Plane, window: Box, [far, near]: readonly [number, number]): Spot[] {
  const whole = around(window).map(([x, y]): Spot => [x, y, plane(x, y)]);
  return cut(
    cut(whole, (z) => near - z),
    (z) => z - far,
  );
}

/** The part of an outline whose depths are inside: there a value that changes evenly is not negative. */
function cut(outline: readonly Spot[], inside: (z: number) => number): Spot[] {
  return outline.flatMap((to, i) => {
    const from = outline.at(i - 1) ?? to;
    const [before, now] = [inside(from[2]), inside(to[2])];
    const kept = now >= 0 ? [to] : [];
    return before >= 0 === now >= 0 ? kept : [between(from, to, before / (before - now)), ...kept];
  });
}

const between = (from: Spot, to: Spot, part: number): Spot => [
  from[0] + (to[0] - from[0]) * part,
  from[1] + (to[1] - from[1]) * part,
  from[2] + (to[2] - from[2]) * part,
];

/** Whether a convex outline holds a point of the plane; its own points belong to it. */
export function holds({ vertices }: Polygon, x: number, y: number): boolean {
  const sides = vertices.map(([x0, y0], i) => {
    const [x1, y1] = vertices[(i + 1) % vertices.length] ?? [x0, y0];
    return Math.sign((x1 - x0) * (y - y0) - (y1 - y0) * (x - x0));
  });
  return !(sides.includes(1) && sides.includes(-1));
}
