import { logTicks } from './ticks.js';

/** A tick: its position and its number. */
export interface Tick {
  readonly at: number;
  readonly value: number;
}

/**
 * The exponent up to which costs and errors are drawn to scale. Arithmetic would overflow beyond it, so larger values are
 * drawn there.
 */
const farthest = 250;

function extent(values: readonly number[]): readonly [number, number] {
  const within = values.map((value) => Math.min(Math.max(value, 10 ** -farthest), 10 ** farthest));
  return [
    within.reduce((a, b) => Math.min(a, b), Infinity),
    within.reduce((a, b) => Math.max(a, b), 0),
  ];
}

/** The range of the cost axis, with a margin on both sides. */
export function costDomain(costs: readonly number[]): readonly [number, number] {
  if (costs.length === 0) return [1, 10];
  const [least, greatest] = extent(costs);
  const margin = Math.max(10 ** (0.05 * (Math.log10(greatest) - Math.log10(least))), 1.1);
  return [least / margin, greatest * margin];
}

/** The exponents between which all finite, nonzero numbers lie. */
function decades(errors: readonly number[]): readonly [number, number] {
  const positive = errors.filter((error) => error > 0 && error < Infinity);
  if (positive.length === 0) return [-3, 0];
  const [low, high] = extent(positive);
  const least = Math.floor(Math.log10(low));
  return [least, Math.max(Math.ceil(Math.log10(high)), least + 1)];
}

/** The heights that the axis of errors needs besides the decades, in pixels. */
export interface Room {
  /** Below the line of the right points, for their names. */
  readonly below: number;
  /** From that line to the one that divides right from wrong, which has a word on either side. */
  readonly word: number;
  /** From one number of the axis to the next, at least. */
  readonly tick: number;
}

/**
 * The error axis, in pixels from the bottom: a line for the right points; above the divide, decades; then if necessary a
 * line for infinity.
 */
export class ErrorAxis {
  /** The line of the right points. */
  readonly right: number;
  /** Between right and wrong. */
  readonly divide: number;
  private readonly bottom: number;
  private readonly top: number;
  private readonly infinite: number | null;
  private readonly domain: readonly [number, number];

  /** `least`: the error of the right picture; what has no greater one is right. */
  constructor(
    errors: readonly number[],
    private readonly least: number,
    private readonly room: Room,
    readonly height: number,
  ) {
    const { below, word, tick } = room;
    const wrong = errors.filter((error) => error > least);
    this.right = below;
    this.divide = below + word;
    this.bottom = this.divide + word;
    this.infinite = wrong.includes(Infinity) ? height - tick / 2 : null;
    this.top = Math.max(height - tick * (this.infinite === null ? 0.5 : 2), this.bottom + 1);
    this.domain = decades(wrong);
  }

  at(error: number): number {
    if (error <= this.least) return this.right;
    if (error === Infinity) return this.infinite ?? this.top;
    const [least, greatest] = this.domain;
    const share = Math.min(1, Math.max(0, (Math.log10(error) - least) / (greatest - least)));
    return this.bottom + share * (this.top - this.bottom);
  }

  ticks(): readonly Tick[] {
    const [least, greatest] = this.domain;
    const range = [10 ** least, 10 ** greatest * 1.0001] as const;
    const values = logTicks(range, this.top - this.bottom, this.room.tick);
    return [
      { at: this.right, value: this.least },
      ...values
        .filter((value) => value > this.least)
        .map((value) => ({ at: this.at(value), value })),
      ...(this.infinite === null ? [] : [{ at: this.infinite, value: Infinity }]),
    ];
  }
}
