import { toNumber } from '../language/words.js';
import { edgeOf, note, path } from '../picture/mark.js';
import type { Mark, Spot } from '../picture/mark.js';
import type { Pixel } from '../picture/pixel.js';
import type { Area, Polygon, Scene } from '../trace/header.js';
import type { N } from '../trace/values.js';
import type { AtPixel, Passing } from './reason.js';

const ways = {
  left: [-1, 0],
  right: [1, 0],
  above: [0, -1],
  below: [0, 1],
  through: [0, 0],
} as const satisfies Record<Passing['passes'], Spot>;

/** Where the line of an edge passes the centre. */
function passingAt({ passes, away }: Passing, [x, y]: Spot): Spot {
  const [right, down] = ways[passes];
  const far = toNumber(away);
  return [x + right * far, y + down * far];
}

/** From the end of an edge to where its line passes; null if the edge itself passes there. */
function extension({ vertices }: Polygon, edge: number, [x, y]: Spot): readonly Spot[] | null {
  const ends = [vertices[edge], vertices[(edge + 1) % vertices.length]].flatMap((end) =>
    end === undefined ? [] : [[end[0], end[1]] as const],
  );
  const [from, to] = ends;
  if (from === undefined || to === undefined) return null;
  const along = (x - from[0]) * (x - to[0]) + (y - from[1]) * (y - to[1]);
  if (along <= 0) return null;
  const distance = (end: Spot): number => Math.hypot(end[0] - x, end[1] - y);
  return [distance(from) < distance(to) ? from : to, [x, y]];
}

/** A place where a label fits into the area. */
const inside = ({ x, y, width, height }: Area, [px, py]: Spot): Spot => [
  Math.min(Math.max(px, x + 0.05 * width), x + 0.9 * width),
  Math.min(Math.max(py, y + 0.08 * height), y + height),
];

/** The polygon of a reason, and its edges that the reason names, each with its distance from the pixel's centre. */
export function reasonMarks(
  { polygon: id, edges = [] }: AtPixel,
  [x, y]: Pixel,
  { area, byId }: Scene,
  short: (value: N) => string,
): readonly Mark[] {
  const polygon = byId.get(id);
  if (polygon === undefined) return [];
  const centre: Spot = [x + 0.5, y + 0.5];
  const passing = edges.flatMap((each): readonly Mark[] => {
    const at = passingAt(each, centre);
    const line = extension(polygon, each.edge, at);
    return [
      ...(line === null ? [] : [path('off', line)]),
      ...edgeOf(polygon, each.edge, 'side'),
      path('reach', [centre, at]),
      note(inside(area, at), short(each.away)),
    ];
  });
  return [path('pointed', polygon.vertices, true), ...passing];
}
