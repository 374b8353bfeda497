import type { Polygon } from './header.js';

type Vertices = Polygon['vertices'];

/** A line from vertex to vertex, back to the first one if it is closed. */
export interface OutlineLine {
  readonly points: Vertices;
  readonly closed: boolean;
}

/** The edge from a vertex of a polygon to the next one, or the same in the opposite direction. */
function edgeOf({ face, vertices }: Polygon, from: number, to: number): string {
  const at = (i: number): string => String(vertices[i % vertices.length]);
  return `${at(from)} ${at(to)} ${face ?? ''}`;
}

/** Finds the outline of one of the polygons, without the edges where it meets other parts of its face. */
export function outlines(
  polygons: readonly Polygon[],
): (polygon: Polygon) => readonly OutlineLine[] {
  const parts = polygons.filter(({ face }) => face !== undefined);
  const edges = new Set(
    parts.flatMap((part) => part.vertices.map((_, i) => edgeOf(part, i, i + 1))),
  );
  return (polygon) => {
    const { face, vertices } = polygon;
    if (face === undefined) return [{ points: vertices, closed: true }];
    return vertices.flatMap((from, i) => {
      if (edges.has(edgeOf(polygon, i + 1, i))) return [];
      return [{ points: [from, vertices[(i + 1) % vertices.length] ?? from], closed: false }];
    });
  };
}

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
