import { edgeThing } from '../algorithm/pointed.js';
import type { Thing } from '../algorithm/pointed.js';
import { numbersOf } from '../algorithm/view.js';
import type { View } from '../algorithm/view.js';
import type { SolidTexts } from '../language/texts.js';
import type { Numbers } from '../language/texts.js';
import { toNumber } from '../language/words.js';
import { currentPolygon } from '../picture/event-marks.js';
import { activeDrawing, cased, column, noDrawing, together } from '../solid/drawing.js';
import type { Drawing } from '../solid/drawing.js';
import type { Space, Spot } from '../solid/space.js';
import type { Event } from '../trace/events.js';
import type { Polygon } from '../trace/header.js';
import type { N } from '../trace/values.js';
import type { ActiveEdge } from './state.js';

/** The Z-buffer in the box: the scanline as a plane parallel to z, its active edges, its spans. */
export function drawing(view: View, space: Space): Drawing {
  const { zbuffer } = view.after;
  if (zbuffer === undefined) return noDrawing;
  const { row, y, ael } = zbuffer;
  const polygon = polygonOf(view);
  const height = y === null ? NaN : toNumber(y);
  return together(
    activeDrawing(currentPolygon(view, zbuffer.polygon)),
    row === null ? {} : scanline(row + 0.5, space),
    polygon ? { lines: ael.flatMap(({ edge }) => edgeLine(polygon, edge)) } : {},
    { lines: spansOf(view).flatMap((span) => cased('side', span, false)) },
    {
      dots: ael.map((entry) => ({ role: 'edge', at: meeting(entry, height) })),
      labels: ael.map((entry) => ({
        text: String(entry.edge),
        at: meeting(entry, height),
        side: [0, -1],
        thing: edgeThing(entry.edge),
      })),
    },
    view.event?.e === 'pixel' ? pixelDrawing(view.event, space, numbersOf(view)) : {},
  );
}

const polygonOf = ({ header, after }: View): Polygon | undefined =>
  header.scene.byId.get(after.zbuffer?.polygon ?? '');

/** An active edge that is pointed at. */
export function pointed(thing: Thing, view: View): Partial<Drawing> {
  const polygon = polygonOf(view);
  if (thing.kind !== 'edge' || polygon === undefined) return {};
  return { lines: edgeLine(polygon, thing.edge, 'pointed') };
}

const meeting = ({ x, z }: ActiveEdge, y: number): Spot => [toNumber(x), y, toNumber(z)];

function scanline(y: number, { area, far, near }: Space): Partial<Drawing> {
  const end = area.x + area.width;
  const points: readonly Spot[] = [
    [area.x, y, far],
    [end, y, far],
    [end, y, near],
    [area.x, y, near],
  ];
  return { faces: [{ points }], lines: cased('scanline', points) };
}

/** An edge of a polygon in 3D. */
function edgeLine(
  { vertices }: Polygon,
  edge: number,
  role: 'edge' | 'pointed' = 'edge',
): Drawing['lines'] {
  const from = vertices[edge];
  const to = vertices[(edge + 1) % vertices.length];
  return from && to ? cased(role, [from, to], false) : [];
}

/** The ends of the lines that ShowLine is showing, in 3D. */
function spansOf({ event, after }: View): readonly (readonly [Spot, Spot])[] {
  const { row = null, ael = [] } = after.zbuffer ?? {};
  const end = ({ x, z }: { readonly x: N; readonly z: N }): Spot => [
    toNumber(x),
    (row ?? NaN) + 0.5,
    toNumber(z),
  ];
  if (event?.e === 'line') {
    const [from, to] = [event.from, event.to].map(([x, z]) => end({ x, z }));
    return from && to ? [[from, to]] : [];
  }
  if (after.calls.at(-1)?.of !== 'ShowLine' && event?.e !== 'span') return [];
  return ael.flatMap((from, i) => {
    const to = ael[i + 1];
    return i % 2 === 0 && to ? [[end(from), end(to)] as const] : [];
  });
}

/** The current pixel as a column, with the stored depth and the new one. */
function pixelDrawing(
  { x, y, z, stored, shown }: Event<'pixel'>,
  space: Space,
  { short }: Numbers,
): Partial<Drawing> {
  const at = (depth: N): Spot => [x + 0.5, y + 0.5, toNumber(depth)];
  return together(column([x, y, 1, 1], space, 'window'), {
    dots: [
      { role: shown ? 'no' : 'yes', at: at(stored) },
      { role: shown ? 'yes' : 'no', at: at(z) },
    ],
    labels: [
      { text: short(stored), at: at(stored), side: [0, 1], strong: !shown },
      { text: short(z), at: at(z), side: [0, -1], strong: shown },
    ],
  });
}

/** A description of a scanline in the box. */
export function caption(view: View, texts: SolidTexts): readonly string[] {
  const { row = null, ael = [] } = view.after.zbuffer ?? {};
  if (row === null) return [];
  const edges = ael.map(({ edge }) => edge).join(', ') || '—';
  const { event } = view;
  return [
    texts.scanline(String(row), edges),
    ...spansOf(view).map(([[x0, , z0], [x1, , z1]]) =>
      texts.span(numbersOf(view).point([x0, z0]), numbersOf(view).point([x1, z1])),
    ),
    ...(event?.e === 'pixel'
      ? [
          texts.pixel(
            numbersOf(view).point([event.x, event.y]),
            numbersOf(view).short(event.z),
            numbersOf(view).short(event.stored),
          ),
        ]
      : []),
  ];
}
