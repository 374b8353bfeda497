import { palette } from '../trace/editions.js';
import type { Area, Polygon, Scene } from '../trace/header.js';
import { surfaceText } from './surface.js';
import type { Formula } from './surface.js';

/**
 * A scene that is being drawn. Each change makes a new one, which shares the unchanged parts. If a function gives the
 * curves, `curves` are from before the last change.
 */
export interface Sketch extends Omit<Scene, 'byId'> {
  readonly formula?: Formula;
}

export type Vertex = Polygon['vertices'][number];

/** A vertex of a sketch, by the indices of its polygon and of the vertex. */
export interface Spot {
  readonly polygon: number;
  readonly vertex: number;
}

export const emptySketch: Sketch = {
  name: '',
  area: { x: 0, y: 0, width: 16, height: 16 },
  background: '#ffffff',
  polygons: [],
  curves: null,
};

/** The file of the scene, `vidno-scene/1` or `vidno-surface/1`, on one line. */
export function sceneText(sketch: Sketch): string {
  if (sketch.curves !== null) return surfaceText(sketch);
  const { name, area, background, polygons } = sketch;
  return JSON.stringify({ format: 'vidno-scene/1', name, window: area, background, polygons });
}

/** The file for people to read: one polygon or curve per line. */
export function sceneFile(sketch: Sketch): string {
  if (sketch.curves !== null) return `${surfaceText(sketch).replaceAll(']],[[', ']],\n [[')}\n`;
  const { polygons, ...rest } = JSON.parse(sceneText(sketch)) as { polygons: unknown[] };
  const lines = polygons.map((polygon) => `  ${JSON.stringify(polygon)}`).join(',\n');
  return `${JSON.stringify(rest).slice(0, -1)},\n "polygons": [\n${lines}\n ]}\n`;
}

const replaced = <T>(list: readonly T[], at: number, ...by: readonly T[]): readonly T[] => [
  ...list.slice(0, at),
  ...by,
  ...list.slice(at + 1),
];

function withPolygon(sketch: Sketch, at: number, change: (old: Polygon) => Polygon): Sketch {
  const old = sketch.polygons[at];
  const changed = old && change(old);
  if (changed === undefined || changed === old) return sketch;
  return { ...sketch, polygons: replaced(sketch.polygons, at, changed) };
}

const withVertices = (polygon: Polygon, vertices: readonly Vertex[]): Polygon => ({
  ...polygon,
  vertices: flattened(vertices),
});

/** Moves a vertex over the screen. */
export function moveVertex(
  sketch: Sketch,
  { polygon, vertex }: Spot,
  x: number,
  y: number,
): Sketch {
  return withPolygon(sketch, polygon, (old) => {
    const z = old.vertices[vertex]?.[2] ?? 0;
    return withVertices(old, replaced(old.vertices, vertex, [x, y, z]));
  });
}

/** Moves a whole polygon over the screen. */
export function movePolygon(sketch: Sketch, polygon: number, dx: number, dy: number): Sketch {
  return withPolygon(sketch, polygon, (old) => ({
    ...old,
    vertices: old.vertices.map(([x, y, z]) => [x + dx, y + dy, z]),
  }));
}

export function setDepth(sketch: Sketch, { polygon, vertex }: Spot, z: number): Sketch {
  return withPolygon(sketch, polygon, (old) => {
    const [x, y] = old.vertices[vertex] ?? [0, 0];
    return withVertices(old, replaced(old.vertices, vertex, [x, y, z]));
  });
}

/** Adds a vertex in the middle of the edge that begins at a vertex. */
export function splitEdge(sketch: Sketch, { polygon, vertex }: Spot): Sketch {
  return withPolygon(sketch, polygon, (old) => {
    const from = old.vertices[vertex];
    const to = old.vertices[(vertex + 1) % old.vertices.length];
    if (from === undefined || to === undefined) return old;
    const middle: Vertex = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2, (from[2] + to[2]) / 2];
    return withVertices(old, replaced(old.vertices, vertex, from, middle));
  });
}

/** Removes a vertex; a polygon keeps at least three. */
export function removeVertex(sketch: Sketch, { polygon, vertex }: Spot): Sketch {
  return withPolygon(sketch, polygon, (old) =>
    old.vertices.length > 3 ? withVertices(old, replaced(old.vertices, vertex)) : old,
  );
}

export function addPolygon(sketch: Sketch, vertices: readonly Vertex[]): Sketch {
  const { polygons } = sketch;
  return {
    ...sketch,
    polygons: [...polygons, { id: freeId(sketch), color: freeColor(sketch), vertices }],
  };
}

/** Adds a polygon of one depth, in front of all others. */
export function drawPolygon(
  sketch: Sketch,
  outline: readonly (readonly [x: number, y: number])[],
): Sketch {
  const depths = sketch.polygons.flatMap(({ vertices }) => vertices.map(([, , z]) => z));
  const nearest = depths.reduce((most, z) => Math.max(most, z), -Infinity);
  const z = depths.length === 0 ? 0 : (Math.floor(4 * nearest) + 1) / 4;
  return addPolygon(
    sketch,
    outline.map(([x, y]) => [x, y, z]),
  );
}

/** The depth of a polygon; null if it is tilted. */
export function depthOf({ polygons }: Sketch, polygon: number): number | null {
  const [first, ...others] = polygons[polygon]?.vertices.map(([, , z]) => z) ?? [];
  return first !== undefined && others.every((z) => z === first) ? first : null;
}

/** Gives all vertices of a polygon the same depth. */
export const setDepthOfAll = (sketch: Sketch, polygon: number, z: number): Sketch =>
  withPolygon(sketch, polygon, (old) => ({
    ...old,
    vertices: old.vertices.map(([x, y]) => [x, y, z]),
  }));

/** The next colour of the palette that nothing in the scene has yet; the palette's next one if all are taken. */
function freeColor({ polygons, background }: Sketch): string {
  const taken = new Set([background, ...polygons.map(({ color }) => color)]);
  const next = polygons.length % palette.length;
  const inTurn = [...palette.slice(next), ...palette.slice(0, next)];
  return inTurn.find((color) => !taken.has(color)) ?? inTurn[0] ?? '#000000';
}

export function removePolygon(sketch: Sketch, polygon: number): Sketch {
  return { ...sketch, polygons: replaced(sketch.polygons, polygon) };
}

/** Exchanges a polygon with the previous or next one; at equal depths the first one wins. */
export function reorder(sketch: Sketch, polygon: number, by: -1 | 1): Sketch {
  const [one, other] = [sketch.polygons[polygon], sketch.polygons[polygon + by]];
  if (one === undefined || other === undefined) return sketch;
  const polygons = replaced(replaced(sketch.polygons, polygon, other), polygon + by, one);
  return { ...sketch, polygons };
}

export function recolor(sketch: Sketch, polygon: number, color: string): Sketch {
  return withPolygon(sketch, polygon, (old) => ({ ...old, color }));
}

/** Whether a vertex lies outside the area. */
export const reachesOut = ({ area, polygons }: Sketch): boolean =>
  polygons.some(({ vertices }) =>
    vertices.some(
      ([x, y]) => x < area.x || x > area.x + area.width || y < area.y || y > area.y + area.height,
    ),
  );

/** Whether a polygon may have this name. */
export const isFree = ({ polygons }: Sketch, polygon: number, id: string): boolean =>
  id !== '' && polygons.every((each, i) => i === polygon || each.id !== id);

/** A name that is not free changes nothing. */
export const rename = (sketch: Sketch, polygon: number, id: string): Sketch =>
  isFree(sketch, polygon, id) ? withPolygon(sketch, polygon, (old) => ({ ...old, id })) : sketch;

export function resize(sketch: Sketch, area: Area): Sketch {
  return { ...sketch, area };
}

function freeId({ polygons }: Sketch): string {
  const taken = new Set(polygons.map(({ id }) => id));
  const letters = Array.from({ length: 26 }, (_, i) => String.fromCharCode(65 + i));
  const numbers = polygons.map((_, i) => String(i + 1));
  return [...letters, ...numbers].find((id) => !taken.has(id)) ?? String(polygons.length + 1);
}

/**
 * A polygon must be plane. The first three vertices that are not collinear on the screen have depths of their own; those of
 * the others follow.
 */
export function flattened(vertices: readonly Vertex[]): readonly Vertex[] {
  const own = anchors(vertices);
  if (own === null || vertices.length === 3) return vertices;
  const [a, b, c] = own.map((i) => vertices[i]) as [Vertex, Vertex, Vertex];
  const area = cross(a, b, c);
  return vertices.map((vertex, i) => {
    if (own.includes(i)) return vertex;
    const [x, y] = vertex;
    const u = cross(a, vertex, c) / area;
    const v = cross(a, b, vertex) / area;
    return [x, y, a[2] + u * (b[2] - a[2]) + v * (c[2] - a[2])];
  });
}

/** The indices of the vertices with depths of their own; null if all vertices are collinear. */
export function anchors(vertices: readonly Vertex[]): readonly number[] | null {
  const [a, b] = vertices;
  const other = vertices.findIndex((each) => a && (each[0] !== a[0] || each[1] !== a[1]));
  const second = vertices[other];
  if (a === undefined || b === undefined || second === undefined) return null;
  const third = vertices.findIndex((each) => cross(a, second, each) !== 0);
  return third < 0 ? null : [0, other, third];
}

const cross = (a: Vertex, b: Vertex, c: Vertex): number =>
  (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
