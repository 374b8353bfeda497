import { Rational } from './rational.js';

export type Place = readonly [x: Rational, y: Rational];
type Corner = readonly [x: Rational, y: Rational, z: Rational];

/** A polygon of a scene, with what is so of it. */
export class ExactPolygon {
  private readonly corners: readonly Corner[];
  /** Twice its area; its sign is that of the inside. */
  private readonly area: Rational;

  constructor({ vertices }: { readonly vertices: readonly (readonly number[])[] }) {
    this.corners = vertices.map(([x = 0, y = 0, z = 0]) => [
      Rational.of(x),
      Rational.of(y),
      Rational.of(z),
    ]);
    const origin: Place = [Rational.of(0), Rational.of(0)];
    this.area = this.corners
      .map((_, i) => this.cross(i, origin))
      .reduce((sum, each) => sum.plus(each));
  }

  get isEdgeOn(): boolean {
    return this.area.sign === 0;
  }

  private edge(i: number): readonly [Corner, Corner] {
    const n = this.corners.length;
    const [from, to] = [this.corners[i % n], this.corners[(i + 1) % n]];
    if (from === undefined || to === undefined) throw new Error('no vertices');
    return [from, to];
  }

  /** The cross product of an edge and a point: positive to its right, as one walks along it on the screen. */
  cross(i: number, [x, y]: Place): Rational {
    const [p, q] = this.edge(i);
    return q[0]
      .minus(p[0])
      .times(y.minus(p[1]))
      .minus(q[1].minus(p[1]).times(x.minus(p[0])));
  }

  /** Whether the point lies in the polygon or on its outline. */
  holds(at: Place): boolean {
    const inside = this.area.sign;
    return !this.isEdgeOn && this.corners.every((_, i) => this.cross(i, at).sign * inside >= 0);
  }

  /** The depth of the plane: Cramer's rule for three corners that are not in line. */
  depth(at: Place): Rational {
    for (let i = 0; i < this.corners.length; i++) {
      const [p, q] = this.edge(i);
      const [, r] = this.edge(i + 1);
      const turn = this.cross(i, [r[0], r[1]]);
      if (turn.sign === 0) continue;
      const from = ([x, y, z]: Corner): Corner => [x.minus(p[0]), y.minus(p[1]), z.minus(p[2])];
      const [u, v] = [from(q), from(r)];
      const [dx, dy] = [at[0].minus(p[0]), at[1].minus(p[1])];
      const along = dx.times(v[1]).minus(dy.times(v[0]));
      const across = u[0].times(dy).minus(u[1].times(dx));
      return p[2].plus(along.times(u[2]).plus(across.times(v[2])).over(turn));
    }
    throw new Error('the polygon is edge-on');
  }
}

/** The polygon that shows at a point by the picture rule, as its place in the list; null for the background. */
export function ownerAt(polygons: readonly ExactPolygon[], at: Place): number | null {
  let nearest: number | null = null;
  let depth: Rational | null = null;
  for (const [i, each] of polygons.entries()) {
    if (!each.holds(at)) continue;
    const own = each.depth(at);
    if (depth === null || own.against(depth) > 0) [nearest, depth] = [i, own];
  }
  return nearest;
}

export const centreOf = (x: number, y: number): Place => [
  Rational.of(x + 0.5),
  Rational.of(y + 0.5),
];
