import { nothing, svg } from 'lit';
import type { SVGTemplateResult } from 'lit';
import { polygonThing } from '../pointed.js';
import type { Polygon } from '../trace/header.js';
import type { Box } from '../trace/values.js';
import type { Mark } from './marks.js';
import type { Pixel } from './pixel.js';

const dot = 5;
const reach = 9;

/** A mark as it is drawn, where the plane is shown at so many CSS pixels a unit. */
export function shapeOf(mark: Mark, scale: number): SVGTemplateResult {
  if (mark.kind === 'box') {
    const [x, y, width, height] = mark.box;
    return svg`<rect class="casing ${mark.role}" x=${x} y=${y} width=${width} height=${height} />
      <rect class=${mark.role} x=${x} y=${y} width=${width} height=${height} />`;
  }
  if (mark.kind === 'point') {
    const [x, y] = mark.at;
    return svg`<circle class="dot ${mark.role}" cx=${x} cy=${y} r=${dot / scale} />`;
  }
  const d =
    mark.kind === 'boxes'
      ? mark.boxes.map(boxData).join('')
      : mark.kind === 'target'
        ? aim(mark.at, reach / scale)
        : pathData(mark.points, mark.closed);
  const color = mark.kind === 'path' ? mark.color : undefined;
  return svg`<path class="casing ${mark.role}" d=${d} />
    <path class=${mark.role} d=${d} stroke=${color ?? nothing} />`;
}

const boxData = ([x, y, width, height]: Box): string => `M${x} ${y}h${width}v${height}h${-width}Z`;

/** The outline of a pixel, and lines that lead to it. */
function aim([x, y]: Pixel, far: number): string {
  const across = `M${x - far} ${y + 0.5}h${far}M${x + 1} ${y + 0.5}h${far}`;
  const down = `M${x + 0.5} ${y - far}v${far}M${x + 0.5} ${y + 1}v${far}`;
  return `M${x} ${y}h1v1h-1Z${across}${down}`;
}

/** The `d` of a path through the points. */
export function pathData(points: readonly (readonly number[])[], closed: boolean): string {
  if (points.length === 0) return '';
  return `M${points.map(([x = 0, y = 0]) => `${x} ${y}`).join('L')}${closed ? 'Z' : ''}`;
}

export function outline({ vertices, color }: Polygon): SVGTemplateResult {
  const d = pathData(vertices, true);
  return svg`<path class="outline-casing" d=${d} /><path class="outline" d=${d} stroke=${color} />`;
}

/** An outline without a look, wide enough to be pointed at. */
export function outlineToPoint({ id, vertices }: Polygon): SVGTemplateResult {
  return svg`<path class="to-point" data-thing=${polygonThing(id)} d=${pathData(vertices, true)} />`;
}
