/** The right answers to questions, computed exactly from the scene by the rules that the questions state. */
import { toNumber } from '../language/words.js';
import type { Question } from '../predict/question.js';
import type { Trace } from '../replay/trace.js';
import { corners as cornerNames, hasThreeLists } from '../trace/events.js';
import type { Polygon } from '../trace/header.js';
import type { Box } from '../trace/values.js';
import { ExactPolygon } from './exact-scene.js';
import type { Place } from './exact-scene.js';
import { Rational } from './rational.js';

type Vertex = readonly [x: Rational, y: Rational, z: Rational];
type Right = Readonly<Record<string, readonly string[]>>;

const verticesOf = ({ vertices }: Polygon): readonly Vertex[] =>
  vertices.map(([x, y, z]) => [Rational.of(x), Rational.of(y), Rational.of(z)]);

type Edge = readonly [from: Vertex, to: Vertex];
const edgesOf = (polygon: Polygon): readonly Edge[] => {
  const all = verticesOf(polygon);
  return all.map((from, i) => [from, all[(i + 1) % all.length] ?? from]);
};

/** f of an edge: positive to its right, as one walks along it on the screen. */
const f = ([[x1, y1], [x2, y2]]: Edge, [x, y]: Place): -1 | 0 | 1 =>
  x2
    .minus(x1)
    .times(y.minus(y1))
    .minus(y2.minus(y1).times(x.minus(x1))).sign;

const covers = (polygon: Polygon, at: Place): boolean => new ExactPolygon(polygon).holds(at);

/** The depth of a polygon's plane; null if it is edge-on. */
function depthOf(polygon: Polygon): ((at: Place) => Rational) | null {
  const exact = new ExactPolygon(polygon);
  return exact.isEdgeOn ? null : (at) => exact.depth(at);
}

interface Sides {
  readonly left: Rational;
  readonly top: Rational;
  readonly right: Rational;
  readonly bottom: Rational;
}
function sidesOf([x, y, width, height]: Box): Sides {
  const [left, top] = [Rational.of(x), Rational.of(y)];
  return { left, top, right: left.plus(Rational.of(width)), bottom: top.plus(Rational.of(height)) };
}

/** In the order of the corners' names: lb, lt, rb, rt, where y grows downward and b is the lesser. */
function cornersOf(window: Box): readonly Place[] {
  const { left, top, right, bottom } = sidesOf(window);
  return [
    [left, top],
    [left, bottom],
    [right, top],
    [right, bottom],
  ];
}
const centreOf = ([x, y, width, height]: Box): Place => [
  Rational.of(x + width / 2),
  Rational.of(y + height / 2),
];

/** The distances of a point from the sides of a window, positive inside: top, left, bottom, right. */
function within(window: Box, [x, y]: Place): readonly (-1 | 0 | 1)[] {
  const { left, top, right, bottom } = sidesOf(window);
  return [y.against(top), x.against(left), bottom.against(y), right.against(x)];
}
const all = (polygon: Polygon, window: Box): readonly (readonly (-1 | 0 | 1)[])[] =>
  verticesOf(polygon).map(([x, y]) => within(window, [x, y]));

/** Whether the box of a polygon has no point in common with a window, its sides included. */
const isBoxOutside = (polygon: Polygon, window: Box): boolean =>
  [0, 1, 2, 3].some((side) => all(polygon, window).every((signs) => signs[side] === -1));
const isBoxInside = (polygon: Polygon, window: Box): boolean =>
  all(polygon, window).every((signs) => signs.every((sign) => sign === 1));

/** Whether an edge has points strictly inside a window: its line separates the corners, and no side the edge. */
function meets(edge: Edge, window: Box): boolean {
  const signs = new Set(cornersOf(window).map((at) => f(edge, at)));
  const ends = edge.map(([x, y]) => within(window, [x, y]));
  const isBeyond = [0, 1, 2, 3].some((side) => ends.every((end) => (end[side] ?? 0) <= 0));
  return signs.has(1) && signs.has(-1) && !isBeyond;
}

type Lies = 'outside' | 'inside' | 'intersecting' | 'surrounding';
function relationOf(polygon: Polygon, window: Box): Lies {
  if (isBoxOutside(polygon, window)) return 'outside';
  if (isBoxInside(polygon, window)) return 'inside';
  if (edgesOf(polygon).some((edge) => meets(edge, window))) return 'intersecting';
  return covers(polygon, centreOf(window)) ? 'surrounding' : 'outside';
}

const surroundsAtCorners = (polygon: Polygon, window: Box): boolean =>
  cornersOf(window).every((at) => covers(polygon, at));

/** The polygon that is found to hide all others: it surrounds the window and is nearer at each corner than those before it, and none after it is nearer at any. */
function hidingIn(
  polygons: readonly Polygon[],
  window: Box,
  surrounds: (polygon: Polygon, window: Box) => boolean,
): string {
  const places = cornersOf(window);
  const nearest: (Rational | null)[] = places.map(() => null);
  let hiding = '';
  for (const polygon of polygons) {
    const depth = depthOf(polygon);
    if (depth === null) return '';
    const nearer = places.map((at, i) => {
      const before = nearest[i] ?? null;
      return before === null || depth(at).against(before) > 0;
    });
    places.forEach((at, i) => {
      if (nearer[i] === true) nearest[i] = depth(at);
    });
    if (nearer.includes(true)) hiding = '';
    if (!nearer.includes(false) && surrounds(polygon, window)) hiding = polygon.id;
  }
  return hiding;
}

const isPixel = ([, , width, height]: Box): boolean => width <= 1 && height <= 1;

function windowAnswer(trace: Trace, question: Question<'window'>): Right {
  const { scene, method } = trace.header;
  const { window } = question.about;
  const listed = (trace.timeline.seek(question.step).values.warnock?.apl?.entries ?? []).map(
    ([id]) => id,
  );
  const third = scene.polygons.filter(({ id }) => listed.includes(id));
  if (!hasThreeLists(method)) {
    const left = third.filter((each) => !isBoxOutside(each, window));
    const hides = method === 'warnock-simplest' ? '' : hidingIn(left, window, surroundsAtCorners);
    const which =
      left.length === 0
        ? 'empty'
        : hides !== ''
          ? 'surrounded'
          : isPixel(window)
            ? 'pixel'
            : left.length === 1 && method !== 'warnock-simplest'
              ? 'single'
              : 'split';
    return { stay: left.map(({ id }) => id), hides: [hides], case: [which] };
  }
  // Which polygons a window's ancestors have sorted out does not matter: they have the same relation to it.
  const takesPart = scene.polygons.filter(
    (each) => method === 'warnock-edges' || depthOf(each) !== null,
  );
  const by = (...lies: readonly Lies[]): readonly Polygon[] =>
    takesPart.filter((each) => lies.includes(relationOf(each, window)));
  const [around, rest] = [by('surrounding'), by('inside', 'intersecting')];
  const shown = by('surrounding', 'inside', 'intersecting');
  const isAround = (each: Polygon): boolean => around.includes(each);
  const isOne = around.length === 1 && rest.length === 0;
  const hides = isOne
    ? (around[0]?.id ?? '')
    : around.length === 0
      ? ''
      : hidingIn(shown, window, isAround);
  const which =
    shown.length === 0
      ? 'empty'
      : around.length === 0 && rest.length === 1
        ? 'single'
        : hides !== ''
          ? 'surrounded'
          : isPixel(window)
            ? 'pixel'
            : 'split';
  return { hides: [hides], case: [which] };
}

const signs = { '-1': '-', 0: '0', 1: '+' } as const;

/** The right answer to each part of a question that the scene alone decides; null for a kind that is not recomputed. */
export function rightAnswers(trace: Trace, question: Question): Right | null {
  const { scene, method } = trace.header;
  const of = (id: string): Polygon => {
    const polygon = scene.byId.get(id);
    if (polygon === undefined) throw new Error(id);
    return polygon;
  };
  const before = trace.timeline.seek(question.step).values;
  if (question.kind === 'window') {
    return windowAnswer(trace, question);
  }
  if (question.kind === 'relation') {
    return { lies: [relationOf(of(question.about.polygon), question.about.window)] };
  }
  if (question.kind === 'trial') {
    const { polygon, edge, window } = question.about;
    const edges = edgesOf(of(polygon));
    const asked = edges[edge];
    const first = edges.findIndex((each) => meets(each, window));
    return {
      cornerSigns: asked ? cornersOf(window).map((at) => signs[f(asked, at)]) : [],
      meetsFirst: [first < 0 ? '' : String(first)],
    };
  }
  if (question.kind === 'inside') {
    const { polygon, point } = question.about;
    const at: Place = [Rational.of(point[0]), Rational.of(point[1])];
    const edges = edgesOf(of(polygon));
    // From the last edge on, until two signs contradict each other.
    const found: string[] = [];
    for (const edge of [...edges.slice(-1), ...edges.slice(0, -1)]) {
      found.push(signs[f(edge, at)]);
      if (found.includes('+') && found.includes('-')) break;
    }
    return { inside: [covers(of(polygon), at) ? 'yes' : 'no'], signs: found };
  }
  if (question.kind === 'corners') {
    const window = before.warnock?.window;
    const nearest = before.warnock?.corners;
    const depth = depthOf(of(question.about.polygon));
    if (!window || !nearest || depth === null) return null;
    const nearer = cornersOf(window).map((at, i) => {
      const stored = nearest[cornerNames[i] ?? 'lb'];
      // The nearest so far is the depth of a plane, or of none; the scene has it without rounding.
      if (stored === '-inf') return true;
      const planes = scene.polygons
        .map((each) => depthOf(each)?.(at))
        .filter((each) => each !== undefined);
      const near = planes.reduce((a, b) =>
        Math.abs(a.number - toNumber(stored)) <= Math.abs(b.number - toNumber(stored)) ? a : b,
      );
      return depth(at).against(near) > 0;
    });
    return { nearer: cornerNames.filter((_, i) => nearer[i] === true) };
  }
  if (question.kind === 'point') {
    const { point } = question.about;
    const at: Place = [Rational.of(point[0]), Rational.of(point[1])];
    const asked = question.parts[0]?.options.map(({ value }) => of(value)) ?? [];
    if (method === 'warnock-edges') return null;
    const covering = asked.filter((each) => covers(each, at));
    const [first] = [...covering].sort(
      (a, b) => depthOf(b)?.(at).against(depthOf(a)?.(at) ?? new Rational(0n)) ?? 0,
    );
    return { covers: covering.map(({ id }) => id), wins: [first?.id ?? ''] };
  }
  if (question.kind === 'depth') {
    const { polygon, point } = question.about;
    const z = depthOf(of(polygon))?.([Rational.of(point[0]), Rational.of(point[1])]);
    return z === undefined ? null : { z: [String(z.number)] };
  }
  if (question.kind === 'ray') {
    const { polygon, window } = question.about;
    const isOdd = covers(of(polygon), centreOf(window));
    const right = question.parts[1]?.right ?? [];
    return { crossings: isOdd === (Number(right[0]) % 2 === 1) ? right : ['another parity'] };
  }
  if (question.kind === 'octants') {
    // A polygon that surrounds the window is traversed clockwise if the window lies to the right of its edges.
    const { polygon, window } = question.about;
    const at = centreOf(window);
    const isRight = edgesOf(of(polygon)).some((edge) => f(edge, at) === 1);
    return { sum: [!covers(of(polygon), at) ? '0' : isRight ? '8' : '-8'] };
  }
  return null;
}
