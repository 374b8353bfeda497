import { nothing, svg } from 'lit';
import type { SVGTemplateResult } from 'lit';
import { polygonThing } from '../pointed.js';
import type { Polygon, Scene } from '../trace/header.js';
import type { Frame } from './frame.js';
import { nearestIn } from './pixel.js';
import type { Pixel } from './pixel.js';
import { outline, outlineToPoint } from './shapes.js';

const mostLabels = 26;
const mostOutlines = 3000;
const many = 40;
const gridFrom = 7;

/** The lines between pixels that are in sight, if they are far enough apart. */
export function grid({ area, shown, scale }: Frame): SVGTemplateResult | typeof nothing {
  if (scale < gridFrom) return nothing;
  const [left, top] = nearestIn([Math.floor(shown[0]), Math.floor(shown[1])], area);
  const ends: Pixel = [Math.ceil(shown[0] + shown[2]), Math.ceil(shown[1] + shown[3])];
  const [right, bottom] = nearestIn(ends, area);
  const [width, height] = [right + 1 - left, bottom + 1 - top];
  const columns = Array.from({ length: width + 1 }, (_, i) => `M${left + i} ${top}v${height}`);
  const rows = Array.from({ length: height + 1 }, (_, j) => `M${left} ${top + j}h${width}`);
  return svg`<path class="grid" d=${[...columns, ...rows].join('')} />`;
}

/** The area and the polygons. */
export function outlines({ area, polygons }: Scene): SVGTemplateResult {
  const { x, y, width, height } = area;
  return svg`
    <rect class="area" x=${x} y=${y} width=${width} height=${height} />
    <g class=${polygons.length > many ? 'many' : nothing}>
      ${polygons.slice(0, mostOutlines).map((polygon) => outline(polygon))}
    </g>
    ${polygons.length > many ? nothing : polygons.map((polygon) => outlineToPoint(polygon))}
  `;
}

/** The polygons' ids. */
export function labels({ polygons }: Scene, frame: Frame): readonly SVGTemplateResult[] {
  if (polygons.length > mostLabels) return [];
  return polygons.map(({ id, vertices }) => {
    const [x, y] = labelSpot(vertices, frame.whole);
    const thing = polygonThing(id);
    return svg`<text class="label" data-thing=${thing} x=${x} y=${y} font-size=${13 / frame.scale}>${id}</text>`;
  });
}

/** A little inward from the first vertex: the middles of polygons often coincide. */
function labelSpot(
  vertices: Polygon['vertices'],
  [x, y, width, height]: Frame['whole'],
): readonly [number, number] {
  const within = (value: number, from: number, size: number): number =>
    Math.min(Math.max(value, from + size * 0.1), from + size * 0.9);
  const spot = (axis: 0 | 1): number => {
    const along = vertices.map((vertex) => vertex[axis]);
    const middle = along.reduce((sum, each) => sum + each, 0) / along.length;
    return (along[0] ?? 0) * 0.8 + middle * 0.2;
  };
  return [within(spot(0), x, width), within(spot(1), y, height)];
}
