import type { N } from '../trace/values.js';

/** A fraction in exact arithmetic; the denominator is positive. */
export interface Fraction {
  readonly p: bigint;
  readonly q: bigint;
}

/** The fraction that a double is, or that a trace writes as "p/q". */
export function fraction(of: N): Fraction {
  if (typeof of === 'string') {
    const [p = '', q = '1'] = of.split('/');
    return { p: BigInt(p), q: BigInt(q) };
  }
  let [scaled, q] = [of, 1n];
  for (; !Number.isInteger(scaled); scaled *= 2) q *= 2n;
  return { p: BigInt(scaled), q };
}

export const plus = (a: Fraction, b: Fraction): Fraction => ({
  p: a.p * b.q + b.p * a.q,
  q: a.q * b.q,
});
export const minus = (a: Fraction, b: Fraction): Fraction => plus(a, { p: -b.p, q: b.q });
export const times = (a: Fraction, b: Fraction): Fraction => ({ p: a.p * b.p, q: a.q * b.q });
export const over = (a: Fraction, b: Fraction): Fraction =>
  b.p < 0n ? { p: -a.p * b.q, q: a.q * -b.p } : { p: a.p * b.q, q: a.q * b.p };
export const sign = ({ p }: Fraction): -1 | 0 | 1 => (p < 0n ? -1 : p > 0n ? 1 : 0);

const divisor = (a: bigint, b: bigint): bigint => (b === 0n ? a : divisor(b, a % b));

/** The nearest double, or, of a long fraction, one beside it. */
export function double({ p, q }: Fraction): number {
  const common = divisor(p < 0n ? -p : p, q);
  const [top, under] = [Number(p / common), Number(q / common)];
  if (Number.isSafeInteger(top) && Number.isSafeInteger(under)) return top / under;
  const digits = 10n ** 30n;
  return Number((p * digits) / q) / 1e30;
}

export type Place = readonly [x: Fraction, y: Fraction];
type Corner = readonly [x: Fraction, y: Fraction, z: Fraction];

/** A polygon of a scene, with what is so of it. */
export class ExactPolygon {
  private readonly corners: readonly Corner[];
  /** Twice its area; its sign is that of the inside. */
  private readonly area: Fraction;

  constructor(
    readonly id: string,
    readonly color: string,
    vertices: readonly (readonly number[])[],
  ) {
    this.corners = vertices.map(([x = 0, y = 0, z = 0]) => [fraction(x), fraction(y), fraction(z)]);
    const origin: Place = [fraction(0), fraction(0)];
    this.area = this.corners.map((_, i) => this.cross(i, origin)).reduce(plus);
  }

  get isEdgeOn(): boolean {
    return sign(this.area) === 0;
  }

  private edge(i: number): readonly [Corner, Corner] {
    const n = this.corners.length;
    const [from, to] = [this.corners[i % n], this.corners[(i + 1) % n]];
    if (from === undefined || to === undefined) throw new Error('no vertices');
    return [from, to];
  }

  /** The cross product of an edge and a point. */
  cross(i: number, [x, y]: Place): Fraction {
    const [p, q] = this.edge(i);
    return minus(
      times(minus(q[0], p[0]), minus(y, p[1])),
      times(minus(q[1], p[1]), minus(x, p[0])),
    );
  }

  holds(at: Place): boolean {
    const inside = sign(this.area);
    return !this.isEdgeOn && this.corners.every((_, i) => sign(this.cross(i, at)) * inside >= 0);
  }

  /** The depth of the plane: Cramer's rule for three corners that are not in line. */
  depth(at: Place): Fraction {
    for (let i = 0; i < this.corners.length; i++) {
      const [p, q] = this.edge(i);
      const [, r] = this.edge(i + 1);
      const turn = this.cross(i, [r[0], r[1]]);
      if (sign(turn) === 0) continue;
      const [u, v] = [
        [minus(q[0], p[0]), minus(q[1], p[1]), minus(q[2], p[2])] as const,
        [minus(r[0], p[0]), minus(r[1], p[1]), minus(r[2], p[2])] as const,
      ];
      const [dx, dy] = [minus(at[0], p[0]), minus(at[1], p[1])];
      const along = minus(times(dx, v[1]), times(dy, v[0]));
      const across = minus(times(u[0], dy), times(u[1], dx));
      return plus(p[2], over(plus(times(along, u[2]), times(across, v[2])), turn));
    }
    throw new Error(`${this.id} is edge-on`);
  }
}

/** The polygon that shows at a point by the picture rule, among the first ones of a scene; null for the background. */
export function ownerAt(polygons: readonly ExactPolygon[], at: Place): ExactPolygon | null {
  let nearest: ExactPolygon | null = null;
  for (const each of polygons) {
    if (!each.holds(at)) continue;
    if (nearest === null || sign(minus(each.depth(at), nearest.depth(at))) > 0) nearest = each;
  }
  return nearest;
}

export const centreOf = (x: number, y: number): Place => [fraction(x + 0.5), fraction(y + 0.5)];
