import type { Polygon } from '../trace/header.js';
import type { Plane } from '../trace/polygon.js';
import type { Box } from '../trace/values.js';
import type { Spot } from './space.js';

/** The corners of a rectangle in order around it. */
export const around = ([x, y, width, height]: Box): readonly (readonly [number, number])[] => [
  [x, y],
  [x + width, y],
  [x + width, y + height],
  [x, y + height],
];

/** The part of a plane over a window and between two depths. */
export function patchOf(plane: Plane, window: Box, [far, near]: readonly [number, number]): Spot[] {
  const whole = around(window).map(([x, y]): Spot => [x, y, plane(x, y)]);
  return cut(
    cut(whole, (z) => near - z),
    (z) => z - far,
  );
}

/** The part of an outline in which a linear function of the depth is not negative. */
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

/** Whether a convex outline contains a point of the plane; boundary points count as inside. */
export function holds({ vertices }: Polygon, x: number, y: number): boolean {
  const sides = vertices.map(([x0, y0], i) => {
    const [x1, y1] = vertices[(i + 1) % vertices.length] ?? [x0, y0];
    return Math.sign((x1 - x0) * (y - y0) - (y1 - y0) * (x - x0));
  });
  return !(sides.includes(1) && sides.includes(-1));
}
