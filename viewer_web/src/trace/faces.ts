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
