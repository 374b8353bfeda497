import { indexFrom } from '../time/goals.js';
import type { Steps } from './parting.js';

/** A longest subsequence in which the second steps rise, from pairs sorted by the first. */
export function rising(pairs: readonly Steps[]): readonly Steps[] {
  // `ends` has, for each length, the subsequence whose last element is least; `before` has the predecessor of each pair.
  const ends: number[] = [];
  const steps: number[] = [];
  const before: number[] = [];
  pairs.forEach(([, other], i) => {
    const length = indexFrom(steps, other);
    before.push(ends[length - 1] ?? -1);
    ends[length] = i;
    steps[length] = other;
  });
  const chosen: Steps[] = [];
  for (let i = ends.at(-1) ?? -1; i >= 0; i = before[i] ?? -1) {
    const pair = pairs[i];
    if (pair !== undefined) chosen.push(pair);
  }
  return chosen.reverse();
}

type Landmarks = ReadonlyMap<string, number>;

/** The landmarks that both runs have, in a common order. */
export function common(one: Landmarks, other: Landmarks): readonly Steps[] {
  const pairs: Steps[] = [];
  for (const [name, step] of one) {
    const there = other.get(name);
    if (there !== undefined) pairs.push([step, there]);
  }
  return rising(pairs);
}

/**
 * Finds the step of another run to show beside a step of one run. From one pair of landmarks to the next both advance step
 * by step, and the run that arrives first waits. Runs without a common landmark are paired proportionally.
 */
export class Pairing {
  private readonly starts: readonly number[];
  private readonly pairs: readonly Steps[];
  readonly byShare: boolean;

  constructor(
    landmarks: readonly Steps[],
    private readonly lengths: Steps,
  ) {
    this.byShare = landmarks.length === 0;
    this.pairs = [[0, 0], ...landmarks, lengths];
    this.starts = this.pairs.map(([one]) => one);
  }

  other(step: number): number {
    const [length, there] = this.lengths;
    if (this.byShare) return length === 0 ? 0 : Math.round((step / length) * there);
    const index = indexFrom(this.starts, step + 1) - 1;
    const [one, other] = this.pairs[index] ?? [0, 0];
    const next = this.pairs[index + 1]?.[1] ?? Infinity;
    return Math.min(other + step - one, Math.max(other, next - 1), there);
  }
}
