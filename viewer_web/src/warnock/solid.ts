import { cornerThing } from '../algorithm/pointed.js';
import type { Thing } from '../algorithm/pointed.js';
import { numbersOf } from '../algorithm/view.js';
import type { View } from '../algorithm/view.js';
import type { Numbers } from '../language/texts.js';
import { toNumber } from '../language/words.js';
import { polygonInHand } from '../picture/in-hand.js';
import { cornerOf } from '../picture/mark.js';
import {
  activeDrawing,
  along,
  cased,
  column,
  level,
  noDrawing,
  together,
} from '../solid/drawing.js';
import type { Dot, Drawing, Label } from '../solid/drawing.js';
import { patchOf } from '../solid/plane.js';
import { planeOf } from '../trace/plane.js';
import type { Space, Spot } from '../solid/space.js';
import type { N, Vertex } from '../trace/values.js';
import { comparedPolygon, cornerDepths } from './solid-corners.js';
import type { CornerDepth } from './solid-corners.js';
import { depthsAtPoint, pointInHand } from './solid-point.js';
import type { Warnock } from './state.js';

/** Warnock's algorithm in the box: the window as a column, and the geometry of the decision in it. */
export function drawing(view: View, space: Space): Drawing {
  const { warnock } = view.after;
  if (warnock === undefined) return noDrawing;
  const { stack, window, clip } = warnock;
  const isAtPoint = pointInHand(view) !== null;
  return together(
    activeDrawing(polygonInHand(view)),
    { lines: stack.flatMap((each) => cased('stacked', level(each.window, space.far))) },
    window ? column(window, space, 'window') : {},
    clip ? clipDrawing(clip) : {},
    isAtPoint ? pointDrawing(view, space) : cornersDrawing(view, space),
  );
}

/** A corner of the window that is pointed at. */
export function pointed(thing: Thing, { after }: View, space: Space): Partial<Drawing> {
  const window = after.warnock?.window;
  if (thing.kind !== 'corner' || !window) return {};
  return { lines: along(...cornerOf(window, thing.corner), space, 'pointed') };
}

const spotOf = (vertex: Vertex): Spot => [
  toNumber(vertex[0]),
  toNumber(vertex[1]),
  toNumber(vertex[2]),
];

function clipDrawing({ vertices, next }: NonNullable<Warnock['clip']>): Partial<Drawing> {
  const kept = next.map(spotOf);
  return {
    lines: [...cased('clip', vertices.map(spotOf)), ...cased('clip-new', kept, false)],
    dots: kept.map((at) => ({ role: 'clip-new', at })),
  };
}

/** The plane of the current polygon over the window, and the depths at the corners. */
function cornersDrawing(view: View, space: Space): Partial<Drawing> {
  const depths = cornerDepths(view);
  return together(planeDrawing(view, space), {
    dots: depths.flatMap(cornerDots),
    labels: depths.flatMap((each) => cornerLabels(each, numbersOf(view))),
  });
}

function planeDrawing(view: View, space: Space): Partial<Drawing> {
  const polygon = view.header.scene.byId.get(comparedPolygon(view) ?? '');
  const window = view.after.warnock?.window;
  if (!polygon || !window) return noDrawing;
  const points = patchOf(planeOf(polygon), window, space.depths);
  const { color } = polygon;
  return { faces: [{ points, color }], lines: cased('clip', points, true, color) };
}

const spotAt = ([x, y]: readonly [number, number], z: N): Spot => [x, y, toNumber(z)];

function cornerDots({ at, stored, own, nearer }: CornerDepth): readonly Dot[] {
  const before: Dot = {
    role: nearer === null ? 'window' : nearer ? 'no' : 'yes',
    at: spotAt(at, stored),
  };
  if (own === null) return [before];
  return [before, { role: nearer === false ? 'no' : 'yes', at: spotAt(at, own) }];
}

/**
 * The new depth is outside the window, with the corner's name. The stored one is beside its point, or outside if it is
 * alone.
 */
function cornerLabels(
  { corner, at, stored, own, nearer }: CornerDepth,
  { short }: Numbers,
): readonly Label[] {
  const across = corner.startsWith('l') ? -1 : 1;
  const outward = corner.endsWith('b') ? -1 : 1;
  const thing = cornerThing(corner);
  const before: Label = {
    text: own === null ? `${corner} ${short(stored)}` : short(stored),
    at: spotAt(at, stored),
    side: [across, own === null ? outward : 0],
    strong: nearer === false,
    thing,
  };
  if (own === null) return [before];
  const text = `${corner} ${short(own)}`;
  const strong = nearer === true;
  return [before, { text, at: spotAt(at, own), side: [across, outward], strong, thing }];
}

/** The line through the point, and its intersections with polygons. */
function pointDrawing(view: View, space: Space): Partial<Drawing> {
  const at = pointInHand(view);
  if (at === null) return noDrawing;
  const depths = depthsAtPoint(view);
  const { short } = numbersOf(view);
  return {
    lines: along(...at, space, 'side'),
    dots: depths.map(({ z, role }) => ({ role, at: spotAt(at, z) })),
    labels: depths.map(({ polygon, z, role, told }) => ({
      text: told ? `${polygon} ${short(z)}` : polygon,
      at: spotAt(at, z),
      side: [1, 0],
      strong: role === 'yes',
    })),
  };
}
