import type { View } from '../algorithm/view.js';
import { signed } from '../language/words.js';
import { edgeOf, note, path, point } from '../picture/mark.js';
import type { Mark, Spot } from '../picture/mark.js';
import type { Warnock } from '../replay/values.js';
import type { Event } from '../trace/events.js';
import type { Polygon, Scene } from '../trace/header.js';
import type { Box } from '../trace/values.js';

/** The distance of the octants' numbers from a window, in sides of the window. */
const outward = 0.4;

/** The part of an outline that the containment test has traversed so far. */
export function containmentMarks(warnock: Warnock | null, scene: Scene): readonly Mark[] {
  const { window = null, contained = [] } = warnock ?? {};
  const last = contained.at(-1);
  if (window === null || last === undefined) return [];
  const polygon = scene.byId.get(last.polygon);
  const current = edgeOf(polygon, last.edge, 'side');
  return last.e === 'ray'
    ? [
        ...rayMarks(window, scene),
        ...current,
        ...contained.flatMap((each) => crossing(each, polygon, window, scene)),
      ]
    : [
        ...octantMarks(window, scene),
        ...current,
        ...contained.flatMap((each) => turn(each, polygon)),
      ];
}

const centreOf = ([x, y, width, height]: Box): Spot => [x + width / 2, y + height / 2];

/** The ends of an edge. */
function endsOf(polygon: Polygon | undefined, edge: number): readonly [Spot, Spot] | null {
  const { vertices = [] } = polygon ?? {};
  const from = vertices[edge];
  const to = vertices[(edge + 1) % vertices.length];
  return from && to
    ? [
        [from[0], from[1]],
        [to[0], to[1]],
      ]
    : null;
}

/** A line from the centre of the window to beyond the whole scene. */
function rayMarks(window: Box, { area, polygons }: Scene): readonly Mark[] {
  const [x, y] = centreOf(window);
  const rightmost = polygons.flatMap(({ vertices }) => vertices.map((vertex) => vertex[0]));
  const end = rightmost.reduce((far, each) => Math.max(far, each), area.x + area.width);
  return [
    path('edge', [
      [x, y],
      [end, y],
    ]),
    point('point', [x, y]),
  ];
}

type Contained = Warnock['contained'][number];

/**
 * The intersection of an edge with the line of the ray, and its count. It is shown at the edge of the area if it is
 * outside.
 */
function crossing(
  event: Contained,
  polygon: Polygon | undefined,
  window: Box,
  { area }: Scene,
): readonly Mark[] {
  const ends = endsOf(polygon, event.edge);
  if (event.e !== 'ray' || ends === null) return [];
  const [[x1, y1], [x2, y2]] = ends;
  const [, y] = centreOf(window);
  const x = event.at === 'CR3' ? x1 : x1 + ((y - y1) / (y2 - y1)) * (x2 - x1);
  const within = Math.max(area.x, Math.min(x, area.x + area.width));
  return [point(event.counts > 0 ? 'yes' : 'no', [x, y]), note([within, y], String(event.counts))];
}

/** The lines of the window's sides, which divide the plane around it into octants, and the numbers of the octants. */
function octantMarks([x, y, width, height]: Box, { area }: Scene): readonly Mark[] {
  const [left, top] = [area.x, area.y];
  const [right, bottom] = [left + area.width, top + area.height];
  const lines = [
    ...[x, x + width].map((at) =>
      path('clip', [
        [at, top],
        [at, bottom],
      ]),
    ),
    ...[y, y + height].map((at) =>
      path('clip', [
        [left, at],
        [right, at],
      ]),
    ),
  ];
  const xs = [x - outward * width, x + width / 2, x + width * (1 + outward)] as const;
  const ys = [y - outward * height, y + height / 2, y + height * (1 + outward)] as const;
  const places: readonly Spot[] = [
    [xs[0], ys[0]],
    [xs[1], ys[0]],
    [xs[2], ys[0]],
    [xs[2], ys[1]],
    [xs[2], ys[2]],
    [xs[1], ys[2]],
    [xs[0], ys[2]],
    [xs[0], ys[1]],
  ];
  return [...lines, ...places.map((at, octant) => note(at, String(octant)))];
}

/** The number of octants by which an edge turns, at its midpoint. */
function turn(event: Contained, polygon: Polygon | undefined): readonly Mark[] {
  const ends = endsOf(polygon, event.edge);
  if (event.e !== 'octants' || ends === null) return [];
  const [[x1, y1], [x2, y2]] = ends;
  return [note([(x1 + x2) / 2, (y1 + y2) / 2], signed(event.difference))];
}

/** The vertex, and the nearest pixel boundaries inside the window. */
export function splitMarks(
  { polygon, vertex, column, row, splits }: Event<'split_vertex'>,
  { header: { scene }, after }: View,
): readonly Mark[] {
  const at = scene.byId.get(polygon)?.vertices[vertex];
  const window = after.warnock?.window;
  if (!at || !window) return [];
  const [x, y, width, height] = window;
  const lines = [
    ...(column > x && column < x + width
      ? [
          path('side', [
            [column, y],
            [column, y + height],
          ]),
        ]
      : []),
    ...(row > y && row < y + height
      ? [
          path('side', [
            [x, row],
            [x + width, row],
          ]),
        ]
      : []),
  ];
  return [...lines, point(splits ? 'yes' : 'no', at)];
}
