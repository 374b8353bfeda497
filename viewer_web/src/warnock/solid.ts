import { cornerThing } from '../algorithm/pointed.js';
import type { Thing } from '../algorithm/pointed.js';
import { numbersOf } from '../algorithm/view.js';
import type { View } from '../algorithm/view.js';
import type { SolidTexts } from '../language/texts.js';
import type { Numbers } from '../language/texts.js';
import { toNumber } from '../language/words.js';
import { currentPolygon } from '../picture/event-marks.js';
import { cornerOf } from '../picture/mark.js';
import type { Role } from '../picture/mark.js';
import type { Warnock } from '../replay/values.js';
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
import { holds, patchOf } from '../solid/plane.js';
import { corners } from '../trace/events.js';
import { planeOf } from '../trace/polygon.js';
import type { Space, Spot } from '../solid/space.js';
import type { Corner, N, Vertex } from '../trace/values.js';
import { shownIn } from './state.js';

/** The depths at a corner of the current window. */
interface CornerDepth {
  readonly corner: Corner;
  readonly at: readonly [x: number, y: number];
  /** The nearest depth before this polygon. */
  readonly stored: N;
  /** The depth of the current polygon's plane, once it is computed. */
  readonly own: N | null;
  /** Whether the current polygon is the nearer one, at the step that decides it. */
  readonly nearer: boolean | null;
}

const isCompared = /^(PW[567]|HP[345])$/;

/** The polygon whose depths at the corners are compared. */
function comparedPolygon({ event }: View): string | null {
  return event !== null && 'polygon' in event && isCompared.test(event.at) ? event.polygon : null;
}

/** The four corners with their depths; empty if the trace does not have them. */
function cornerDepths(view: View): readonly CornerDepth[] {
  const { event, before, after } = view;
  const { window = null, depths = [], corners: now } = after.warnock ?? {};
  // The step that copies the nearer depths shows the depths that they were compared with.
  const stored = event?.e === 'nearer' ? before.warnock?.corners : now;
  if (window === null || !stored) return [];
  const isCurrent = comparedPolygon(view) !== null;
  return corners.map((corner, i) => ({
    corner,
    at: cornerOf(window, corner),
    stored: stored[corner],
    own: (isCurrent ? depths[i] : null) ?? null,
    nearer: answerAt(corner, view),
  }));
}

function answerAt(corner: Corner, { event }: View): boolean | null {
  if (event?.e === 'nearer') return event.corners.includes(corner);
  return event?.e === 'compare' && event.corner === corner ? event.nearer : null;
}

/** The depth of a polygon on the line through the current point. */
interface PointDepth {
  readonly polygon: string;
  readonly z: N;
  /** Whether the procedure has computed it. A later depth is only drawn. */
  readonly isReported: boolean;
  readonly role: Role;
}

/** The point whose colour PointColor determines: the middle of the window. */
function testedPoint({ event, after }: View): readonly [number, number] | null {
  const runs = after.calls.some(({ of }) => of === 'PointColor') || event?.e === 'color';
  const window = after.warnock?.window;
  if (!runs || !window) return null;
  return [window[0] + window[2] / 2, window[1] + window[3] / 2];
}

/** The polygons of the list that contain the point, in the order of the list. */
function depthsAtPoint(view: View): readonly PointDepth[] {
  const at = testedPoint(view);
  const { warnock } = view.after;
  if (at === null || warnock === undefined) return [];
  const { nearest } = warnock;
  return shownIn(warnock, view.header.scene).flatMap((id): readonly PointDepth[] => {
    const polygon = view.header.scene.byId.get(id);
    if (polygon === undefined || !holds(polygon, ...at)) return [];
    if (nearest?.polygon === id)
      return [{ polygon: id, z: nearest.z, isReported: true, role: 'yes' }];
    const z = testedDepth(view, id);
    if (z === null) {
      return [{ polygon: id, z: planeOf(polygon)(...at), isReported: false, role: 'window' }];
    }
    return [
      { polygon: id, z, isReported: true, role: view.event?.e === 'compare' ? 'no' : 'point' },
    ];
  });
}

function testedDepth({ event }: View, id: string): N | null {
  return (event?.e === 'depth' || event?.e === 'compare') && event.polygon === id ? event.z : null;
}

/** Warnock's algorithm in the box: the window as a column, and the geometry of the decision in it. */
export function drawing(view: View, space: Space): Drawing {
  const { warnock } = view.after;
  if (warnock === undefined) return noDrawing;
  const { stack, window, clip } = warnock;
  const isAtPoint = testedPoint(view) !== null;
  return together(
    activeDrawing(currentPolygon(view)),
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
  const at = testedPoint(view);
  if (at === null) return noDrawing;
  const depths = depthsAtPoint(view);
  const { short } = numbersOf(view);
  return {
    lines: along(...at, space, 'side'),
    dots: depths.map(({ z, role }) => ({ role, at: spotAt(at, z) })),
    labels: depths.map(({ polygon, z, role, isReported }) => ({
      text: isReported ? `${polygon} ${short(z)}` : polygon,
      at: spotAt(at, z),
      side: [1, 0],
      strong: role === 'yes',
    })),
  };
}

/** A description of a window in the box. */
export function caption(view: View, texts: SolidTexts): readonly string[] {
  const { window = null, clip = null } = view.after.warnock ?? {};
  if (window === null) return [];
  return [
    texts.window(numbersOf(view).windowText(window)),
    ...(testedPoint(view) === null ? cornerWords(view, texts) : pointWords(view, texts)),
    ...(clip === null ? [] : [texts.clip]),
  ];
}

function cornerWords(view: View, texts: SolidTexts): readonly string[] {
  const depths = cornerDepths(view);
  const polygon = comparedPolygon(view);
  const { joined, short } = numbersOf(view);
  const own = depths.flatMap((each) =>
    each.own === null ? [] : [`${each.corner} ${short(each.own)}`],
  );
  const stored = depths.map((each) => `${each.corner} ${short(each.stored)}`);
  return [
    ...(polygon === null || own.length === 0 ? [] : [texts.plane(polygon, joined(own))]),
    ...(stored.length === 0 ? [] : [texts.corners(joined(stored))]),
  ];
}

function pointWords(view: View, texts: SolidTexts): readonly string[] {
  const at = testedPoint(view) ?? [];
  const { joined, point, short } = numbersOf(view);
  const depths = depthsAtPoint(view).map(({ polygon, z, isReported }) =>
    isReported ? `${polygon} ${short(z)}` : polygon,
  );
  return [texts.point(point(at), joined(depths) || texts.noPolygon)];
}
