import { expect } from 'vitest';
import { toNumber } from '../language/words.js';
import type { Header, Polygon } from '../trace/header.js';
import { planeOf } from '../trace/polygon.js';
import type { Box } from '../trace/values.js';
import { sorted } from './questions.js';
import type { Agrees } from './questions.js';

type Kinds = 'painted' | 'plane' | 'facing' | 'split' | 'trial' | 'depth' | 'edgeDepth' | 'fill';
type Place = readonly [x: number, y: number];

function polygonOf({ scene }: Header, id: string): Polygon {
  const polygon = scene.byId.get(id);
  if (polygon === undefined) throw new Error(id);
  return polygon;
}

type End = readonly [x: number, y: number, z: number];

const edgesOf = (corners: readonly (readonly number[])[]): readonly (readonly [End, End])[] => {
  const ends = corners.map(([x = 0, y = 0, z = 0]): End => [x, y, z]);
  return ends.map((from, i) => [from, ends[(i + 1) % ends.length] ?? from]);
};

/** Positive on one side of the line from p to q, negative on the other. */
const side = ([p, q]: readonly [End, End], [x, y]: Place): number =>
  (q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0]);

/** Whether an edge has points strictly inside a window: Liang and Barsky's clipping. */
function passes([p, q]: readonly [End, End], [x, y, width, height]: Box): boolean {
  let [first, last] = [0, 1];
  for (const [from, to, low, high] of [
    [p[0], q[0], x, x + width],
    [p[1], q[1], y, y + height],
  ] as const) {
    if (from === to) {
      if (from <= low || from >= high) return false;
      continue;
    }
    const ends = [(low - from) / (to - from), (high - from) / (to - from)];
    first = Math.max(first, Math.min(...ends));
    last = Math.min(last, Math.max(...ends));
  }
  return first < last;
}

/** The greatest z of an edge at a point of its line; null if the point is beyond its ends. */
function depthOn([p, q]: readonly [End, End], at: Place): number | null {
  if (p[0] === q[0] && p[1] === q[1]) {
    return p[0] === at[0] && p[1] === at[1] ? Math.max(p[2], q[2]) : null;
  }
  const axis = Math.abs(q[0] - p[0]) > Math.abs(q[1] - p[1]) ? 0 : 1;
  const t = (at[axis] - p[axis]) / (q[axis] - p[axis]);
  return t >= 0 && t <= 1 ? p[2] + t * (q[2] - p[2]) : null;
}

const isCorrected = ({ edition }: Header): boolean => edition === 'corrected';

/** The answers about polygons, computed from the scene. */
export const polygonsAgree: Readonly<Record<Kinds, Agrees>> = {
  plane: ({ trace: { header }, question, right }) => {
    if (question.kind !== 'plane' || !isCorrected(header)) return;
    const [a = NaN, b = NaN, d = NaN] = right['plane']?.map(Number) ?? [];
    const c = toNumber(question.about.c);
    for (const [x = 0, y = 0, z = 0] of polygonOf(header, question.about.polygon).vertices) {
      const scale = Math.max(...[a * x, b * y, c * z, d].map(Math.abs));
      expect(Math.abs(a * x + b * y + c * z + d)).toBeLessThanOrEqual(scale * 1e-6);
    }
  },
  facing: ({ trace: { header }, question, right }) => {
    // On the screen, where y grows downward, a face that is traversed clockwise has a positive area.
    const asked = question.parts[0]?.options.map(({ value }) => value) ?? [];
    const away = asked.filter(
      (id) =>
        edgesOf(polygonOf(header, id).vertices)
          .map(([p, q]) => p[0] * q[1] - q[0] * p[1])
          .reduce((sum, each) => sum + each, 0) > 0,
    );
    expect(sorted(right['away'])).toEqual(sorted(away));
  },
  split: ({ trace: { header }, question, right }) => {
    if (question.kind !== 'split') return;
    const { polygon, vertex, window } = question.about;
    const [x = NaN, y = NaN] = polygonOf(header, polygon).vertices[vertex] ?? [];
    const [column = NaN, row = NaN] = right['boundaries']?.map(Number) ?? [];
    expect([column, row]).toEqual([Math.ceil(x - 0.5) + 0, Math.ceil(y - 0.5) + 0]);
    const [left, top, width, height] = window;
    const isInside = (left < column && column < left + width) || (top < row && row < top + height);
    expect(right['splits']).toEqual([isInside ? 'yes' : 'no']);
  },
  trial: ({ trace: { header }, question, right }) => {
    if (question.kind !== 'trial' || !isCorrected(header)) return;
    const { polygon, edge, window } = question.about;
    const { vertices } = polygonOf(header, polygon);
    if (vertices.flat().some((value) => Math.abs(value) > 2 ** 20)) return;
    const edges = edgesOf(vertices);
    const [x, y, width, height] = window;
    const corners: readonly Place[] = [
      [x, y],
      [x, y + height],
      [x + width, y],
      [x + width, y + height],
    ];
    const asked = edges[edge];
    const signs = corners.map((at) => '-0+'[Math.sign(asked ? side(asked, at) : NaN) + 1]);
    expect(right['cornerSigns']).toEqual(signs);
    const first = edges.findIndex((each) => passes(each, window));
    expect(right['meetsFirst']).toEqual([first < 0 ? '' : String(first)]);
  },
  depth: ({ trace: { header }, question, right }) => {
    if (question.kind !== 'depth' || !isCorrected(header)) return;
    const [x = NaN, y = NaN] = question.about.point.map(toNumber);
    const z = planeOf(polygonOf(header, question.about.polygon))(x, y);
    const size = Math.max(1, Math.abs(z));
    if (Math.abs(z) < 1e3) expect(Number(right['z']?.[0]) / size).toBeCloseTo(z / size, 3);
  },
  painted: ({ trace: { header }, question, right }) => {
    if (question.kind !== 'painted') return;
    const { polygon, other, point } = question.about;
    const [x = NaN, y = NaN] = point.map(toNumber);
    const [z = NaN, otherZ = NaN] = [polygon, other].map((id) =>
      planeOf(polygonOf(header, id))(x, y),
    );
    const [ofOne, ofOther] = right['bothDepths']?.map(Number) ?? [];
    expect(ofOne).toBeCloseTo(z, 6);
    expect(ofOther).toBeCloseTo(otherZ, 6);
    if (Math.abs(z - otherZ) > 1e-6) expect(right['nearerThere']).toEqual([z > otherZ ? '>' : '<']);
  },
  edgeDepth: ({ trace: { header }, question, right }) => {
    if (question.kind !== 'edgeDepth') return;
    const [x = NaN, y = NaN] = question.about.point.map(toNumber);
    const depths = edgesOf(polygonOf(header, question.about.polygon).vertices).map((edge) =>
      depthOn(edge, [x, y]),
    );
    const spanning = depths.flatMap((z, edge) => (z === null ? [] : [String(edge)]));
    expect(sorted(right['spanning'])).toEqual(sorted(spanning));
    const nearest = Math.max(...depths.map((z) => z ?? -Infinity));
    expect(Number(right['z']?.[0])).toBeCloseTo(nearest, 9);
  },
  fill: ({ question, right }) => {
    if (question.kind !== 'fill') return;
    const { row, outline } = question.about;
    const edges = edgesOf(outline.map((at) => at.map(toNumber)));
    for (const { value } of question.parts[0]?.options ?? []) {
      const sides = edges.map((edge) => side(edge, [Number(value) + 0.5, row + 0.5]));
      if (sides.some((each) => Math.abs(each) < 1e-6)) continue; // on an edge that was rounded
      const isInside = sides.every((each) => each > 0) || sides.every((each) => each < 0);
      expect([value, right['covered']?.includes(value)]).toEqual([value, isInside]);
    }
  },
};
