import type { Area, Polygon, Scene } from '../trace/header.js';
import type { Frame } from './frame.js';
import { boxData, pathData } from './shapes.js';
import type { Shape } from './shapes.js';

const mostLabels = 26;
const mostOutlines = 3000;
const many = 40;
const gridFrom = 7;

/** CSS pixels. */
export const labelSize = 13;

/** Grid, border and outlines, which do not change from step to step. */
export function stillShapes({ area, polygons }: Scene, { scale }: Frame): readonly Shape[] {
  const border: Shape = { look: 'area', d: boxData([area.x, area.y, area.width, area.height]) };
  const outlines = polygons.slice(0, mostOutlines);
  return [
    ...(scale >= gridFrom ? [grid(area)] : []),
    border,
    ...outlines.flatMap(polygons.length > many ? faintOutline : outline),
  ];
}

function grid({ x, y, width, height }: Area): Shape {
  const columns = Array.from({ length: width + 1 }, (_, i) => `M${x + i} ${y}v${height}`);
  const rows = Array.from({ length: height + 1 }, (_, j) => `M${x} ${y + j}h${width}`);
  return { look: 'grid', d: [...columns, ...rows].join('') };
}

function outline({ vertices, color }: Polygon): readonly Shape[] {
  const d = pathData(vertices, true);
  return [
    { look: 'outline-casing', d },
    { look: 'outline', d, color },
  ];
}

/** Many outlines would hide the picture. */
function faintOutline({ vertices, color }: Polygon): Shape {
  return { look: 'outline many', d: pathData(vertices, true), color };
}

/** A polygon's name, and where in the plane its middle stands. */
export interface Label {
  readonly text: string;
  readonly at: readonly [x: number, y: number];
}

export function labelsOf({ polygons }: Scene, { shown }: Frame): readonly Label[] {
  if (polygons.length > mostLabels) return [];
  return polygons.map(({ id, vertices }) => ({ text: id, at: labelSpot(vertices, shown) }));
}

/** A little inward from the first vertex: the middles of polygons often coincide. */
function labelSpot(
  vertices: Polygon['vertices'],
  [x, y, width, height]: Frame['shown'],
): Label['at'] {
  const within = (value: number, from: number, size: number): number =>
    Math.min(Math.max(value, from + size * 0.1), from + size * 0.9);
  const spot = (axis: 0 | 1): number => {
    const along = vertices.map((vertex) => vertex[axis]);
    const middle = along.reduce((sum, each) => sum + each, 0) / along.length;
    return (along[0] ?? 0) * 0.8 + middle * 0.2;
  };
  return [within(spot(0), x, width), within(spot(1), y, height)];
}
