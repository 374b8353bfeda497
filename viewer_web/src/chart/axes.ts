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

interface Plotted {
  readonly error: number;
  readonly series: string;
}

/**
 * The error axis, in pixels from the bottom: a band for zero, then decades, then if necessary a band for infinity. Each
 * series has a lane in the bands, so that equal errors do not overlap.
 */
export class ErrorAxis {
  /** The top of the band for zero. */
  readonly zeroBand: number;
  /** The bottom of the band for infinity. */
  readonly infiniteBand: number;
  private readonly domain: readonly [number, number];

  private readonly zeroLanes: readonly string[];
  private readonly infiniteLanes: readonly string[];

  /** `series`: in the order of their lanes. */
  constructor(
    points: readonly Plotted[],
    series: readonly string[],
    private readonly laneHeight: number,
    readonly height: number,
  ) {
    const lanesAt = (at: number): readonly string[] => {
      const found = new Set(
        points.filter(({ error }) => error === at).map((point) => point.series),
      );
      return series.filter((each) => found.has(each));
    };
    this.zeroLanes = lanesAt(0);
    this.infiniteLanes = lanesAt(Infinity);
    this.domain = decades(points.map(({ error }) => error));
    this.zeroBand = this.bandOf(Math.max(1, this.zeroLanes.length));
    this.infiniteBand = height - this.bandOf(this.infiniteLanes.length);
  }

  private bandOf(lanes: number): number {
    return lanes === 0 ? 0 : (lanes + 0.5) * this.laneHeight;
  }

  /** The space between a band and the decades, which is empty. */
  private get gap(): number {
    return this.laneHeight * 0.7;
  }

  at(error: number, series = ''): number {
    const inBand = (lanes: readonly string[]): number =>
      (lanes.length - lanes.indexOf(series) - 0.25) * this.laneHeight;
    if (error === 0) return inBand(this.zeroLanes);
    if (error === Infinity) return this.infiniteBand + inBand(this.infiniteLanes);
    const [least, greatest] = this.domain;
    const share = Math.min(1, Math.max(0, (Math.log10(error) - least) / (greatest - least)));
    return this.bottom + share * (this.top - this.bottom);
  }

  private get bottom(): number {
    return this.zeroBand + this.gap;
  }

  private get top(): number {
    return this.infiniteBand - this.gap;
  }

  ticks(): readonly Tick[] {
    const [least, greatest] = this.domain;
    const range = [10 ** least, 10 ** greatest * 1.0001] as const;
    const values = logTicks(range, this.top - this.bottom, this.laneHeight * 1.6);
    return [
      { at: this.zeroBand / 2, value: 0 },
      ...values.map((value) => ({ at: this.at(value), value })),
      ...(this.infiniteBand < this.height
        ? [{ at: (this.infiniteBand + this.height) / 2, value: Infinity }]
        : []),
    ];
  }
}
