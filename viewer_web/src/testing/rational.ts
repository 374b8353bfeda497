import type { N } from '../trace/values.js';

const divisor = (a: bigint, b: bigint): bigint => (b === 0n ? a : divisor(b, a % b));

/** Exact arithmetic for tests: a fraction with a positive denominator, not reduced. */
export class Rational {
  constructor(
    private readonly above: bigint,
    private readonly below = 1n,
  ) {}

  /** The exact value of a double, or of a fraction "p/q" as a trace has it. */
  static of(value: N): Rational {
    if (typeof value === 'string') {
      const [top = '0', under = '1'] = value.split('/');
      return new Rational(BigInt(top), BigInt(under));
    }
    let below = 1n;
    let rest: number = value;
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

  /** The nearest double, or, of a long fraction, one beside it. */
  get number(): number {
    const common = divisor(this.above < 0n ? -this.above : this.above, this.below);
    const [top, under] = [Number(this.above / common), Number(this.below / common)];
    if (Number.isSafeInteger(top) && Number.isSafeInteger(under)) return top / under;
    return Number((this.above * 10n ** 30n) / this.below) / 1e30;
  }
}
