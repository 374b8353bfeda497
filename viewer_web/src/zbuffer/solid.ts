import { toNumber } from '../language/words.js';
import { edgeThing } from '../algorithm/pointed.js';
import type { ActiveEdge } from './state.js';
import type { Event } from '../trace/events.js';
import type { Polygon } from '../trace/header.js';
import type { N } from '../trace/values.js';
import type { Numbers } from '../language/texts.js';
import { numbersOf } from '../algorithm/view.js';
import type { View } from '../algorithm/view.js';
import { cased, column, noDrawing, together } from '../solid/drawing.js';
import type { Drawing } from '../solid/drawing.js';
import type { Space, Spot } from '../solid/space.js';

/** The Z-buffer in the box: the scanline as a plane parallel to z, its active edges, its spans. */
export function zbufferDrawing(view: View, space: Space): Drawing {
  const { zbuffer } = view.after;
  if (zbuffer === null) return noDrawing;
  const { row, y, ael } = zbuffer;
  const polygon = view.header.scene.byId.get(zbuffer.polygon ?? '');
  const height = y === null ? NaN : toNumber(y);
  return together(
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

/** An edge of a polygon where it is in space. */
export function edgeLine(
  { vertices }: Polygon,
  edge: number,
  role: 'edge' | 'pointed' = 'edge',
): Drawing['lines'] {
  const from = vertices[edge];
  const to = vertices[(edge + 1) % vertices.length];
  return from && to ? cased(role, [from, to], false) : [];
}

/** The ends of the lines that ShowLine has in hand, in space. */
export function spansOf({ event, after }: View): readonly (readonly [Spot, Spot])[] {
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

/** The pixel in hand as a column, with the stored depth and the new one. */
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
