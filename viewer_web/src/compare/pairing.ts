import { indexFrom } from '../time/goals.js';
import type { Steps } from './parting.js';

/** Of pairs in the order of their first steps, a longest choice in which the second ones rise, too. */
export function rising(pairs: readonly Steps[]): readonly Steps[] {
  // Of the choices of each length the one that ends lowest, and for each pair the one before it in its choice.
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

/** The landmarks that both runs have. */
export function common(one: Landmarks, other: Landmarks): readonly Steps[] {
  const pairs: Steps[] = [];
  for (const [name, step] of one) {
    const there = other.get(name);
    if (there !== undefined) pairs.push([step, there]);
  }
  return rising(pairs);
}

/**
 * For a step of one run the step of another that is shown beside it: from one pair of landmarks to the next both go on step
 * by step, and who is sooner there waits. Runs without a common landmark are paired by their share of the run.
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
