import { Rational } from './rational.js';

type Sample = readonly [x: number, y: number];
/** A curve without gaps, from left to right. */
export type Curve = readonly Sample[];

const whole = (n: number): Rational => new Rational(BigInt(n));

function on([x0, y0]: Sample, [x1, y1]: Sample, x: number): Rational {
  const rise = Rational.of(y1).minus(Rational.of(y0));
  return Rational.of(y0).plus(
    whole(x - x0)
      .times(rise)
      .over(whole(x1 - x0)),
  );
}

/**
 * Curves in exact arithmetic, for tests: over each column their heights, and the horizons of the curves and side edges before
 * each. y grows downward, so the upper horizon is the least height.
 */
export class ExactCurves {
  constructor(private readonly curves: readonly Curve[]) {}

  private curve = (number: number): Curve => this.curves[number] ?? [];

  height(number: number, x: number): Rational | null {
    const samples = this.curve(number);
    for (let i = 1; i < samples.length; i++) {
      const [from, to] = [samples[i - 1], samples[i]];
      if (from && to && from[0] <= x && x <= to[0]) return on(from, to, x);
    }
    return null;
  }

  /** The heights that curves before this one, and the edges up to its left one, have over a column. */
  private before(number: number, x: number): readonly Rational[] {
    const found: Rational[] = [];
    for (let each = 0; each < number; each++) {
      const height = this.height(each, x);
      if (height !== null) found.push(height);
    }
    for (let each = 1; each <= number; each++) {
      for (const end of each < number ? [0, -1] : [0]) {
        const [one, other] = [this.curve(each - 1).at(end), this.curve(each).at(end)];
        if (!one || !other || Math.min(one[0], other[0]) >= x || x >= Math.max(one[0], other[0])) {
          continue;
        }
        found.push(on(one, other, x));
      }
    }
    return found;
  }

  horizons(
    number: number,
    x: number,
  ): { readonly upper: Rational; readonly lower: Rational } | null {
    const [first, ...others] = this.before(number, x);
    if (first === undefined) return null;
    const pick = (sign: 1 | -1): Rational =>
      others.reduce((best, each) => (each.against(best) === sign ? each : best), first);
    return { upper: pick(-1), lower: pick(1) };
  }

  /** Whether the curve is on the upper horizon or above it, and whether it is on the lower one or below it. */
  reaches(number: number, x: number): { readonly upper: boolean; readonly lower: boolean } {
    const [y, horizons] = [this.height(number, x), this.horizons(number, x)];
    if (y === null || horizons === null) return { upper: true, lower: true };
    return { upper: y.against(horizons.upper) <= 0, lower: y.against(horizons.lower) >= 0 };
  }

  /** Where a curve crosses a horizon between a column and the next. */
  crossings(number: number, x: number): readonly (readonly [x: Rational, y: Rational])[] {
    const [left, right] = [this.height(number, x), this.height(number, x + 1)];
    const [from, to] = [this.horizons(number, x), this.horizons(number, x + 1)];
    if (left === null || right === null || from === null || to === null) return [];
    return (['upper', 'lower'] as const).flatMap((side) => {
      const [first, last] = [left.minus(from[side]), right.minus(to[side])];
      if (first.sign * last.sign >= 0) return [];
      const t = first.over(first.minus(last));
      return [[whole(x).plus(t), left.plus(t.times(right.minus(left)))] as const];
    });
  }
}
