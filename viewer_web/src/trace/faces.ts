import type { Polygon } from './header.js';

type Vertices = Polygon['vertices'];

/** A line from vertex to vertex, back to the first one if it is closed. */
export interface OutlineLine {
  readonly points: Vertices;
  readonly closed: boolean;
}

const key = (vertex: Vertices[number] | undefined): string => String(vertex);

/** The outline of a polygon, without the edges where it meets other parts of its face. */
export function outlineLines(
  polygon: Polygon,
  polygons: readonly Polygon[],
): readonly OutlineLine[] {
  const { face, vertices } = polygon;
  const whole: OutlineLine = { points: vertices, closed: true };
  if (face === undefined) return [whole];
  const others = polygons.filter((each) => each !== polygon && each.face === face);
  const inside = new Set(
    others.flatMap(({ vertices: of }) =>
      of.map((to, i) => `${key(of[(i + 1) % of.length])} ${key(to)}`),
    ),
  );
  const edges = vertices.map(
    (from, i) => [from, vertices[(i + 1) % vertices.length] ?? from] as const,
  );
  const drawn = edges.filter(([from, to]) => !inside.has(`${key(from)} ${key(to)}`));
  return drawn.length === edges.length
    ? [whole]
    : drawn.map((points) => ({ points, closed: false }));
}
