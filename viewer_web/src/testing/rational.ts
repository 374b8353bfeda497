/** Exact arithmetic for tests: a fraction with a positive denominator, not reduced. */
export class Rational {
  constructor(
    private readonly above: bigint,
    private readonly below = 1n,
  ) {}

  /** The exact value of a double. */
  static of(value: number): Rational {
    let below = 1n;
    let rest = value;
    while (!Number.isInteger(rest)) {
      rest *= 2;
      below *= 2n;
    }
    return new Rational(BigInt(rest), below);
  }

  plus({ above, below }: Rational): Rational {
    return new Rational(this.above * below + above * this.below, this.below * below);
  }

  minus({ above, below }: Rational): Rational {
    return this.plus(new Rational(-above, below));
  }

  times({ above, below }: Rational): Rational {
    return new Rational(this.above * above, this.below * below);
  }

  over({ above, below }: Rational): Rational {
    const sign = above < 0n ? -1n : 1n;
    return new Rational(sign * this.above * below, sign * this.below * above);
  }

  get sign(): -1 | 0 | 1 {
    return this.above > 0n ? 1 : this.above < 0n ? -1 : 0;
  }

  /** Negative if it is less than another. */
  against(other: Rational): -1 | 0 | 1 {
    return this.minus(other).sign;
  }

  get number(): number {
    return Number((this.above * 10n ** 12n) / this.below) / 1e12;
  }
}
