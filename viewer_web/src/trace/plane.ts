import type { Polygon } from './header.js';

/** The depth of a plane at a point; not finite if the plane is seen edge-on. */
export type Plane = (x: number, y: number) => number;

/** The plane of a polygon, for drawing only: Newell's sum relative to the first vertex. */
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
