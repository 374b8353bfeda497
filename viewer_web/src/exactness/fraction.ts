/** A fraction in lowest terms with a positive denominator, with arithmetic. */
export class Fraction {
  private constructor(
    readonly p: bigint,
    readonly q: bigint,
  ) {}

  static of(p: bigint | number, q: bigint | number = 1n): Fraction {
    const [above, below] = [BigInt(p), BigInt(q)];
    if (below === 0n) throw new RangeError('a division by zero');
    const sign = below < 0n ? -1n : 1n;
    const divisor = greatestDivisor(above, below) * sign;
    return new Fraction(above / divisor, below / divisor);
  }

  /** Null if the text is not a fraction "p/q", such as "nan". */
  static parse(text: string): Fraction | null {
    const [, p, q] = /^(-?\d+)\/(\d+)$/.exec(text) ?? [];
    return p === undefined || q === undefined || BigInt(q) === 0n
      ? null
      : Fraction.of(BigInt(p), BigInt(q));
  }

  plus(other: Fraction): Fraction {
    return Fraction.of(this.p * other.q + other.p * this.q, this.q * other.q);
  }

  minus(other: Fraction): Fraction {
    return Fraction.of(this.p * other.q - other.p * this.q, this.q * other.q);
  }

  times(other: Fraction): Fraction {
    return Fraction.of(this.p * other.p, this.q * other.q);
  }

  over(other: Fraction): Fraction {
    return Fraction.of(this.p * other.q, this.q * other.p);
  }

  get sign(): -1 | 0 | 1 {
    if (this.p === 0n) return 0;
    return this.p < 0n ? -1 : 1;
  }

  /** The greatest whole number that is not above it. */
  get floor(): bigint {
    const quotient = this.p / this.q;
    return quotient * this.q > this.p ? quotient - 1n : quotient;
  }

  /** As written by hand: 3 for 3/1, with a real minus sign. */
  get text(): string {
    const written = this.q === 1n ? String(this.p) : `${this.p}/${this.q}`;
    return written.replace('-', '−');
  }

  /** In brackets if it would be ambiguous beside an operator. */
  get inner(): string {
    return this.p < 0n || this.q !== 1n ? `(${this.text})` : this.text;
  }
}

export const half = Fraction.of(1n, 2n);

function greatestDivisor(a: bigint, b: bigint): bigint {
  let [x, y] = [a < 0n ? -a : a, b < 0n ? -b : b];
  while (y !== 0n) [x, y] = [y, x % y];
  return x;
}
